// Preloaded: a system that has room for few more threads of this process; see `limit_threads`.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>

typedef void* (*Run)(void*);

typedef struct {
  Run run;
  void* argument;
} Start;

static atomic_int limit = -1;  // of the threads that run at once and were started since; below 0: none
static atomic_int running = 0;
static atomic_int refused = 0;

void limit_threads(int count) {
  atomic_store(&running, 0);
  atomic_store(&refused, 0);
  atomic_store(&limit, count);
}

int refused_threads(void) { return atomic_load(&refused); }

static void* run_counted(void* argument) {
  Start start = *(Start*)argument;
  free(argument);
  void* result = start.run(start.argument);
  atomic_fetch_sub(&running, 1);
  return result;
}

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, Run run, void* argument) {
  const int most = atomic_load(&limit);
  if (atomic_fetch_add(&running, 1) >= most && most >= 0) {
    atomic_fetch_sub(&running, 1);
    atomic_fetch_add(&refused, 1);
    return EAGAIN;
  }
  Start* start = malloc(sizeof *start);
  *start = (Start){run, argument};
  return ((int (*)(pthread_t*, const pthread_attr_t*, Run, void*))dlsym(RTLD_NEXT, "pthread_create"))(
      thread, attributes, run_counted, start);
}
