#include "dds/library.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <memory>
#include <mutex>

#include "dds/self_test.hpp"
#include "dds/topic_type.hpp"
#include "dds/version.hpp"

#ifdef _WIN32
#define WIN32_LEAN_AND_MEAN
#include <windows.h>
#else
#include <dlfcn.h>
#endif

namespace tfloom::dds {
namespace {

// The versions that all tests ran with, in the builds of PyPI.
constexpr const char* tried_versions[] = {"11.0.1"};

#ifdef _WIN32
std::wstring utf16_of(const std::string& utf8) {
  const int size = static_cast<int>(utf8.size());
  const int length = MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, utf8.data(), size, nullptr, 0);
  std::wstring text(static_cast<std::size_t>(length), L'\0');
  MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, utf8.data(), size, text.data(), length);
  return text;
}

// Libraries that it needs are searched for beside it, and in the system's folders and those of os.add_dll_directory.
void* open_shared_library(const std::string& path) {
  constexpr DWORD places = LOAD_LIBRARY_SEARCH_DLL_LOAD_DIR | LOAD_LIBRARY_SEARCH_DEFAULT_DIRS;
  void* handle = LoadLibraryExW(utf16_of(path).c_str(), nullptr, places);
  if (handle == nullptr) throw Error("cannot open " + path + ": Windows error " + std::to_string(GetLastError()));
  return handle;
}

void* find_symbol(void* handle, const char* name) {
  return reinterpret_cast<void*>(GetProcAddress(static_cast<HMODULE>(handle), name));
}
#else
void* open_shared_library(const std::string& path) {
  void* handle = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) throw Error(std::string("cannot open the DDS library: ") + dlerror());
  return handle;
}

void* find_symbol(void* handle, const char* name) { return dlsym(handle, name); }
#endif

class Resolver {
 public:
  explicit Resolver(const std::string& path) : path_(path), handle_(open_shared_library(path)) {}

  template <typename Function>
  void operator()(Function*& function, const char* name) const {
    find(function, name);
    if (function == nullptr) throw Error(path_ + " has no " + name + ": it isn't Cyclone DDS 0.10 or 11");
  }

  // Set `function` to nullptr if the library doesn't have it.
  template <typename Function>
  void find(Function*& function, const char* name) const {
    function = reinterpret_cast<Function*>(find_symbol(handle_, name));
  }

  [[nodiscard]] void* handle() const { return handle_; }

  [[nodiscard]] std::string version() const {
    return version_of_library(handle_, find_symbol(handle_, "dds_create_domain"));
  }

 private:
  std::string path_;
  void* handle_;  // never closed, because the library's threads may outlive all objects of this process
};

void resolve_all(Library& l, const Resolver& resolve) {
#define TFLOOM_RESOLVE(prefix, result, name, parameters) resolve(l.name, #prefix #name);
  TFLOOM_DDS_FUNCTIONS(TFLOOM_RESOLVE)
#undef TFLOOM_RESOLVE
  resolve(l.delete_entity, "dds_delete");
  resolve.find(l.get_entity_sertype, "dds_get_entity_sertype");
  if (l.get_entity_sertype != nullptr) return;
  resolve(l.entity_pin, "dds_entity_pin");
  resolve(l.entity_unpin, "dds_entity_unpin");
}

void check_major_version(const std::string& path, const std::string& version) {
  const std::string dotted = version + ".";
  if (version.empty() || dotted.starts_with("11.") || dotted.starts_with("0.10.")) return;
  throw Error(path + " is Cyclone DDS " + version + ", and only 0.10 and 11 can be used");
}

bool was_tried(const std::string& version) {
  return std::ranges::find(tried_versions, version) != std::end(tried_versions);
}

void check_interface(Library& library, const std::string& path) {
  try {
    if (library.get_entity_sertype == nullptr) library.topic_type_offset = measure_type_offset(library);
    run_self_test(library);
  } catch (const Error& error) {
    const std::string version = library.version.empty() ? "of unknown version" : library.version;
    throw Error("libddsc " + version + " in " + path + " fails the test of its interface: " + error.what());
  }
}

}  // namespace

const Library& Library::open(const std::string& path, bool is_common_build) {
  static std::mutex mutex;
  static std::map<std::string, std::unique_ptr<const Library>> libraries;  // guarded by mutex
  const std::lock_guard lock(mutex);
  auto& library = libraries[path];
  if (!library) {
    auto opened = std::make_unique<Library>();
    const Resolver resolve(path);
    resolve_all(*opened, resolve);
    opened->handle = resolve.handle();
    opened->version = resolve.version();
    check_major_version(path, opened->version);
    if (!is_common_build || !was_tried(opened->version)) check_interface(*opened, path);
    library = std::move(opened);  // only now: after a failure, the next call tries again
  }
  return *library;
}

Result Library::check(Result result, const std::string& what) const {
  if (result < 0) throw Error(what + ": " + strretcode(result));
  return result;
}

}  // namespace tfloom::dds
