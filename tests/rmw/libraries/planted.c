// A library that forwards to libddsc (REAL), and differs from it in one type: that of the macro which is defined.
#include <dlfcn.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

__attribute__((unused)) static void* real(const char* name) { return dlsym(dlopen(REAL, RTLD_NOW), name); }

#if defined(WIDER_SAMPLE_INFO) || defined(SWAPPED_SAMPLE_INFO)
enum { info_size = 64, most = 64 };

typedef int32_t receive_function(int32_t, void**, uint32_t, void*, uint32_t);

static int32_t receive(const char* name, int32_t reader, void** samples, uint32_t count, char* infos, uint32_t mask) {
  char found[most * info_size];
  const int32_t received = ((receive_function*)real(name))(reader, samples, count < most ? count : most, found, mask);
  for (int32_t i = 0; i < received; ++i) {
#ifdef WIDER_SAMPLE_INFO
    memcpy(infos + i * (info_size + 8), found + i * info_size, info_size);
    memset(infos + i * (info_size + 8) + info_size, 0, 8);
#else
    char* info = infos + i * info_size;
    memcpy(info, found + i * info_size, info_size);
    memcpy(info + 24, found + i * info_size + 32, 8);
    memcpy(info + 32, found + i * info_size + 24, 8);
#endif
  }
  return received;
}

int32_t dds_readcdr(int32_t reader, void** samples, uint32_t count, void* infos, uint32_t mask) {
  return receive("dds_readcdr", reader, samples, count, infos, mask);
}

int32_t dds_takecdr(int32_t reader, void** samples, uint32_t count, void* infos, uint32_t mask) {
  return receive("dds_takecdr", reader, samples, count, infos, mask);
}
#endif

#ifdef WIDER_TAKE
int32_t dds_take(int32_t reader, void** samples, void* infos, size_t size, uint32_t count) {
  const int32_t taken =
      ((int32_t(*)(int32_t, void**, void*, size_t, uint32_t))real("dds_take"))(reader, samples, infos, size, count);
  if (taken > 0) memset((char*)infos + taken * 64, 0, 8);
  return taken;
}
#endif

#ifdef LONGER_GUID
int32_t dds_get_guid(int32_t entity, char* guid) {
  memset(guid + 16, 0, 4);
  return ((int32_t(*)(int32_t, char*))real("dds_get_guid"))(entity, guid);
}
#endif

#ifdef LONGER_STATUS
int32_t dds_get_sample_lost_status(int32_t reader, char* status) {
  memset(status + 8, 0, 4);
  return ((int32_t(*)(int32_t, char*))real("dds_get_sample_lost_status"))(reader, status);
}
#endif

#ifdef SHORTER_STATUS
int32_t dds_get_publication_matched_status(int32_t writer, char* status) {
  char found[24];
  const int32_t result = ((int32_t(*)(int32_t, char*))real("dds_get_publication_matched_status"))(writer, found);
  memcpy(status, found, 16);
  return result;
}
#endif

#ifdef STATUS_BY_VALUE
struct status {
  uint32_t total_count;
  int32_t total_count_change;
  uint32_t last_policy_id;
};
struct longer_status {
  struct status first;
  uint32_t more[3];
};
static void (*wanted)(int32_t, struct longer_status, void*);
static void* wanted_argument;

static void call_with_longer_status(int32_t entity, struct status status, void* argument) {
  (void)argument;
  const struct longer_status longer = {status, {0, 0, 0}};
  wanted(entity, longer, wanted_argument);
}

int32_t dds_lset_offered_incompatible_qos_arg(void* listener, void* function, void* argument, bool reset) {
  wanted = function;
  wanted_argument = argument;
  return ((int32_t(*)(void*, void*, void*, bool))real("dds_lset_offered_incompatible_qos_arg"))(
      listener, call_with_longer_status, NULL, reset);
}
#endif

#ifdef MORE_MATCHES
int32_t dds_get_matched_publications(int32_t reader, uint64_t* handles, size_t size) {
  const int32_t count =
      ((int32_t(*)(int32_t, uint64_t*, size_t))real("dds_get_matched_publications"))(reader, handles, size);
  if (handles != NULL && (size_t)count < size) handles[count] = 0;
  return count;
}
#endif

#ifdef LATER_TOPIC_NAME
void* dds_get_matched_publication_data(int32_t reader, uint64_t handle) {
  char* found = ((void* (*)(int32_t, uint64_t))real("dds_get_matched_publication_data"))(reader, handle);
  char* longer = malloc(72);
  memcpy(longer, found, 40);
  memset(longer + 40, 0x11, 8);  // a new member, and no address
  memcpy(longer + 48, found + 40, 24);
  return longer;
}
#endif

#ifdef SHORTER_VIEW
void* ddsi_serdata_to_ser_ref(const void* sample, size_t offset, size_t size, char* view) {
  char found[32];
  void* reference = ((void* (*)(const void*, size_t, size_t, char*))real("ddsi_serdata_to_ser_ref"))(
      sample, offset, size, found);
  memcpy(view, found, 8);
  return reference;
}
#endif

#ifdef OTHER_RESULT_CODES
int32_t dds_create_domain(uint32_t domain, const char* config) {
  const int32_t result = ((int32_t(*)(uint32_t, const char*))real("dds_create_domain"))(domain, config);
  return result == -4 ? -5 : result;
}
#endif

#ifdef NARROWER_DEPTH
bool dds_qget_history(const void* qos, int32_t* kind, int16_t* depth) {
  int32_t found;
  const bool has = ((bool (*)(const void*, int32_t*, int32_t*))real("dds_qget_history"))(qos, kind, &found);
  *depth = (int16_t)found;
  return has;
}
#endif
