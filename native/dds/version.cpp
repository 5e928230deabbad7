#include "dds/version.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>

#ifdef __linux__
#include <dlfcn.h>
#include <link.h>
#elif defined(__APPLE__)
#include <dlfcn.h>
#include <mach-o/loader.h>
#endif

namespace tfloom::dds {

#ifdef __linux__
namespace {

const char* soname(const link_map& library) {
  ElfW(Addr) strings = 0;
  std::size_t offset = 0;
  bool has_name = false;
  for (const ElfW(Dyn)* entry = library.l_ld; entry->d_tag != DT_NULL; ++entry) {
    if (entry->d_tag == DT_STRTAB) strings = entry->d_un.d_ptr;
    if (entry->d_tag == DT_SONAME) {
      offset = entry->d_un.d_val;
      has_name = true;
    }
  }
  if (!has_name || strings == 0) return "";
  if (strings < library.l_addr) strings += library.l_addr;  // musl leaves it relative, glibc doesn't
  return reinterpret_cast<const char*>(strings) + offset;
}

// Return the numbers after `.so.` in the name of a library or of its file; empty if what follows isn't a version.
std::string version_in(const std::string& name) {
  const std::size_t begin = name.rfind(".so.");
  if (begin == std::string::npos) return "";
  std::string version = name.substr(begin + 4);
  version.erase(std::min(version.find(' '), version.size()));  // a file in memory is named `… (deleted)`
  return version.find_first_not_of("0123456789.") == std::string::npos ? version : "";
}

std::string file_name(const link_map& library) {
  const std::unique_ptr<char, void (*)(void*)> path(realpath(library.l_name, nullptr), std::free);
  const std::string whole = path == nullptr ? "" : path.get();
  return whole.substr(whole.find_last_of('/') + 1);
}

}  // namespace

std::string version_of_library(void* handle, const void*) {
  const link_map* library = nullptr;
  if (dlinfo(handle, RTLD_DI_LINKMAP, &library) != 0) return "";
  // Debian replaces the SONAME (`libddsc.so.0debian`), and not the name of the file behind the link.
  const std::string version = version_in(soname(*library));
  return version.empty() ? version_in(file_name(*library)) : version;
}

#elif defined(__APPLE__)

std::string version_of_library(void*, const void* symbol) {
  Dl_info info{};
  if (dladdr(symbol, &info) == 0) return "";
  const auto* header = static_cast<const mach_header_64*>(info.dli_fbase);
  const auto* place = reinterpret_cast<const std::byte*>(header + 1);
  for (std::uint32_t i = 0; i < header->ncmds; ++i) {
    const auto* command = reinterpret_cast<const load_command*>(place);
    if (command->cmd == LC_ID_DYLIB) {
      const std::uint32_t version = reinterpret_cast<const dylib_command*>(place)->dylib.current_version;
      return std::to_string(version >> 16U) + "." + std::to_string((version >> 8U) & 0xffU) + "." +
             std::to_string(version & 0xffU);
    }
    place += command->cmdsize;
  }
  return "";
}

#else

std::string version_of_library(void*, const void*) { return ""; }

#endif

}  // namespace tfloom::dds
