// A shared mutex that prefers writers. With std::shared_mutex on glibc, a few busy readers can block a writer for
// seconds: two writers at 1 kHz beside two busy readers insert less than half as often, and wait 20 times as long (p99)
// or more. Lookups gain nothing: benchmarks/native, "fair mutex".
#pragma once

#include <shared_mutex>  // on glibc, defines __GLIBC__ too

#ifdef __GLIBC__
#include <pthread.h>
#endif

namespace tfloom::tf2 {

#ifdef __GLIBC__

class FairMutex {
 public:
  FairMutex() {
    pthread_rwlockattr_t attributes;
    pthread_rwlockattr_init(&attributes);
    pthread_rwlockattr_setkind_np(&attributes, PTHREAD_RWLOCK_PREFER_WRITER_NONRECURSIVE_NP);
    pthread_rwlock_init(&lock_, &attributes);
    pthread_rwlockattr_destroy(&attributes);
  }
  FairMutex(const FairMutex&) = delete;
  FairMutex& operator=(const FairMutex&) = delete;
  ~FairMutex() { pthread_rwlock_destroy(&lock_); }

  // None of these fails on an initialised lock that the calling thread does not hold.
  void lock() { pthread_rwlock_wrlock(&lock_); }
  void unlock() { pthread_rwlock_unlock(&lock_); }
  void lock_shared() { pthread_rwlock_rdlock(&lock_); }
  void unlock_shared() { pthread_rwlock_unlock(&lock_); }

 private:
  pthread_rwlock_t lock_;
};

#else

using FairMutex = std::shared_mutex;  // fair on macOS and Windows

#endif

}  // namespace tfloom::tf2
