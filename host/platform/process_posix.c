/* SPDX-License-Identifier: MIT */
#define _GNU_SOURCE /* RTLD_DEFAULT */
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include "platform/process.h"

/* If a standard stream is closed, the next file opened would become it and receive its messages.
   Its place is taken in the wrong direction, so that using it stays an error. */
static void reserve_standard_streams(void) {
  for (int descriptor = 0; descriptor <= 2; descriptor++) {
    if (fcntl(descriptor, F_GETFD) == -1) {
      (void)!open("/dev/null", descriptor == 0 ? O_WRONLY : O_RDONLY);
    }
  }
}

void process_begin(int *argc, char ***argv) {
  (void)argc;
  (void)argv;
  reserve_standard_streams();
}

unsigned process_processors(void) {
  const long processors = sysconf(_SC_NPROCESSORS_ONLN);
  return processors < 1 ? 1 : (unsigned)processors;
}

void *process_loaded_function(const char *name) { return dlsym(RTLD_DEFAULT, name); }

int process_run(const char *const *words) {
  extern char **environ;
  pid_t child;
  /* Arguments are not changed; C has no type for that. */
  errno = posix_spawnp(&child, words[0], NULL, NULL, (char *const *)words, environ);
  if (errno != 0) return -1;
  int status;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) return -1;
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

void *process_allocate_aligned(size_t alignment, size_t size) {
  return aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
}

void process_free_aligned(void *memory) { free(memory); }
