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

void resolve_entities(Library& l, const Resolver& resolve) {
  resolve(l.create_domain, "dds_create_domain");
  resolve(l.create_participant, "dds_create_participant");
  resolve(l.create_publisher, "dds_create_publisher");
  resolve(l.create_subscriber, "dds_create_subscriber");
  resolve(l.create_topic, "dds_create_topic");
  resolve(l.create_writer, "dds_create_writer");
  resolve(l.create_reader, "dds_create_reader");
  resolve(l.delete_entity, "dds_delete");
  resolve(l.get_guid, "dds_get_guid");
  resolve.find(l.get_entity_sertype, "dds_get_entity_sertype");
  if (l.get_entity_sertype == nullptr) {
    resolve(l.entity_pin, "dds_entity_pin");
    resolve(l.entity_unpin, "dds_entity_unpin");
  }
  resolve(l.set_listener, "dds_set_listener");
  resolve(l.strretcode, "dds_strretcode");
  resolve(l.free, "dds_free");
  resolve(l.get_matched_publications, "dds_get_matched_publications");
  resolve(l.get_matched_subscriptions, "dds_get_matched_subscriptions");
  resolve(l.get_matched_publication_data, "dds_get_matched_publication_data");
  resolve(l.get_matched_subscription_data, "dds_get_matched_subscription_data");
  resolve(l.builtintopic_free_endpoint, "dds_builtintopic_free_endpoint");
  resolve(l.create_listener, "dds_create_listener");
  resolve(l.delete_listener, "dds_delete_listener");
  resolve(l.lset_data_available_arg, "dds_lset_data_available_arg");
}

void resolve_data(Library& l, const Resolver& resolve) {
  resolve(l.write, "dds_write");
  resolve(l.writecdr, "dds_writecdr");
  resolve(l.unregister_instance, "dds_unregister_instance");
  resolve(l.readcdr, "dds_readcdr");
  resolve(l.takecdr, "dds_takecdr");
  resolve(l.take, "dds_take");
  resolve(l.return_loan, "dds_return_loan");
  resolve(l.serdata_from_ser_iov, "ddsi_serdata_from_ser_iov");
  resolve(l.serdata_size, "ddsi_serdata_size");
  resolve(l.serdata_to_ser_ref, "ddsi_serdata_to_ser_ref");
  resolve(l.serdata_to_ser_unref, "ddsi_serdata_to_ser_unref");
  resolve(l.serdata_unref, "ddsi_serdata_unref");
}

void resolve_events(Library& l, const Resolver& resolve) {
  resolve(l.lset_publication_matched_arg, "dds_lset_publication_matched_arg");
  resolve(l.lset_subscription_matched_arg, "dds_lset_subscription_matched_arg");
  resolve(l.lset_offered_incompatible_qos_arg, "dds_lset_offered_incompatible_qos_arg");
  resolve(l.lset_requested_incompatible_qos_arg, "dds_lset_requested_incompatible_qos_arg");
  resolve(l.lset_offered_deadline_missed_arg, "dds_lset_offered_deadline_missed_arg");
  resolve(l.lset_requested_deadline_missed_arg, "dds_lset_requested_deadline_missed_arg");
  resolve(l.lset_liveliness_lost_arg, "dds_lset_liveliness_lost_arg");
  resolve(l.lset_liveliness_changed_arg, "dds_lset_liveliness_changed_arg");
  resolve(l.lset_sample_lost_arg, "dds_lset_sample_lost_arg");
  resolve(l.get_publication_matched_status, "dds_get_publication_matched_status");
  resolve(l.get_subscription_matched_status, "dds_get_subscription_matched_status");
  resolve(l.get_offered_incompatible_qos_status, "dds_get_offered_incompatible_qos_status");
  resolve(l.get_requested_incompatible_qos_status, "dds_get_requested_incompatible_qos_status");
  resolve(l.get_offered_deadline_missed_status, "dds_get_offered_deadline_missed_status");
  resolve(l.get_requested_deadline_missed_status, "dds_get_requested_deadline_missed_status");
  resolve(l.get_liveliness_lost_status, "dds_get_liveliness_lost_status");
  resolve(l.get_liveliness_changed_status, "dds_get_liveliness_changed_status");
  resolve(l.get_sample_lost_status, "dds_get_sample_lost_status");
  resolve(l.assert_liveliness, "dds_assert_liveliness");
  resolve(l.wait_for_acks, "dds_wait_for_acks");
}

void resolve_qos(Library& l, const Resolver& resolve) {
  resolve(l.create_qos, "dds_create_qos");
  resolve(l.delete_qos, "dds_delete_qos");
  resolve(l.qset_userdata, "dds_qset_userdata");
  resolve(l.qset_reliability, "dds_qset_reliability");
  resolve(l.qset_durability, "dds_qset_durability");
  resolve(l.qset_durability_service, "dds_qset_durability_service");
  resolve(l.qset_history, "dds_qset_history");
  resolve(l.qset_deadline, "dds_qset_deadline");
  resolve(l.qset_lifespan, "dds_qset_lifespan");
  resolve(l.qset_liveliness, "dds_qset_liveliness");
  resolve(l.qset_data_representation, "dds_qset_data_representation");
  resolve(l.qset_writer_data_lifecycle, "dds_qset_writer_data_lifecycle");
  resolve(l.qget_userdata, "dds_qget_userdata");
  resolve(l.qget_reliability, "dds_qget_reliability");
  resolve(l.qget_durability, "dds_qget_durability");
  resolve(l.qget_history, "dds_qget_history");
  resolve(l.qget_deadline, "dds_qget_deadline");
  resolve(l.qget_lifespan, "dds_qget_lifespan");
  resolve(l.qget_liveliness, "dds_qget_liveliness");
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
    resolve_entities(*opened, resolve);
    resolve_data(*opened, resolve);
    resolve_events(*opened, resolve);
    resolve_qos(*opened, resolve);
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
