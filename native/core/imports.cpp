#include "core/imports.hpp"

#if defined(__linux__) && (defined(__x86_64__) || defined(__aarch64__))
#include <elf.h>
#include <link.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#endif

namespace tfloom {

#if defined(__linux__) && (defined(__x86_64__) || defined(__aarch64__))
namespace {

#ifdef __x86_64__
constexpr std::uint32_t jump_slot = R_X86_64_JUMP_SLOT;
constexpr std::uint32_t data_slot = R_X86_64_GLOB_DAT;
#else
constexpr std::uint32_t jump_slot = R_AARCH64_JUMP_SLOT;
constexpr std::uint32_t data_slot = R_AARCH64_GLOB_DAT;
#endif

// What the dynamic section of a loaded library points to (System V ABI, chapter 5).
struct Dynamic {
  const char* names = nullptr;
  const ElfW(Sym)* symbols = nullptr;
  std::span<const ElfW(Rela)> calls;
  std::span<const ElfW(Rela)> relocations;
};

Dynamic read_dynamic(const link_map& library) {
  // glibc has added the library's address to these values; musl has not.
  const auto address = [&](ElfW(Addr) value) { return value < library.l_addr ? value + library.l_addr : value; };
  Dynamic dynamic;
  const ElfW(Rela)* calls = nullptr;
  const ElfW(Rela)* relocations = nullptr;
  std::size_t calls_size = 0;
  std::size_t relocations_size = 0;
  for (const ElfW(Dyn)* entry = library.l_ld; entry->d_tag != DT_NULL; ++entry) {
    switch (entry->d_tag) {
      case DT_STRTAB: dynamic.names = reinterpret_cast<const char*>(address(entry->d_un.d_ptr)); break;
      case DT_SYMTAB: dynamic.symbols = reinterpret_cast<const ElfW(Sym)*>(address(entry->d_un.d_ptr)); break;
      case DT_JMPREL: calls = reinterpret_cast<const ElfW(Rela)*>(address(entry->d_un.d_ptr)); break;
      case DT_RELA: relocations = reinterpret_cast<const ElfW(Rela)*>(address(entry->d_un.d_ptr)); break;
      case DT_PLTRELSZ: calls_size = entry->d_un.d_val; break;
      case DT_RELASZ: relocations_size = entry->d_un.d_val; break;
      default: break;
    }
  }
  if (calls != nullptr) dynamic.calls = {calls, calls_size / sizeof(ElfW(Rela))};
  if (relocations != nullptr) dynamic.relocations = {relocations, relocations_size / sizeof(ElfW(Rela))};
  return dynamic;
}

// The slot may be in pages that the loader has made read-only (PT_GNU_RELRO); others write near it, so it stays writable.
bool store(void** slot, void* function) {
  const auto page_size = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  const std::uintptr_t page = reinterpret_cast<std::uintptr_t>(slot) / page_size * page_size;
  if (mprotect(reinterpret_cast<void*>(page), page_size, PROT_READ | PROT_WRITE) != 0) return false;
  __atomic_store_n(slot, function, __ATOMIC_RELEASE);
  return true;
}

}  // namespace

std::string replace_import(const link_map& library, const char* name, void* replacement) {
  const Dynamic dynamic = read_dynamic(library);
  if (dynamic.names == nullptr || dynamic.symbols == nullptr) return "it has no table of symbols";
  bool is_replaced = false;
  for (const auto& table : {dynamic.calls, dynamic.relocations}) {
    for (const ElfW(Rela)& entry : table) {
      const auto kind = static_cast<std::uint32_t>(ELF64_R_TYPE(entry.r_info));
      if (kind != jump_slot && kind != data_slot) continue;
      const ElfW(Sym)& symbol = dynamic.symbols[ELF64_R_SYM(entry.r_info)];
      if (std::strcmp(dynamic.names + symbol.st_name, name) != 0) continue;
      if (!store(reinterpret_cast<void**>(library.l_addr + entry.r_offset), replacement)) {
        return std::string("its import of ") + name + " is write-protected";
      }
      is_replaced = true;
    }
  }
  return is_replaced ? "" : std::string("it does not import ") + name;
}
#else
std::string replace_import(const link_map&, const char*, void*) { return "this is done on Linux only, on x86-64 and arm64"; }
#endif

}  // namespace tfloom
