/* SPDX-License-Identifier: MIT */
/* Manifests of `tabor library`: a folder with a manifest of somebody else's making is taken or
 * refused, and the file is not changed. */
#define _GNU_SOURCE
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/command.h"
#include "fuzz.h"
#include "library/library_manifest.h"

static char folder[] = "/tmp/fuzz_manifest.XXXXXX";
static char path[sizeof folder + sizeof "/" LIBRARY_MANIFEST];

static void remove_folder(void) {
  (void)unlink(path);
  (void)rmdir(folder);
}

static LibraryRequest *make_request(void) {
  static LibraryRequest request;
  static Arguments arguments;
  fuzz_require(mkdtemp(folder) != NULL, "a folder");
  (void)snprintf(path, sizeof path, "%s/%s", folder, LIBRARY_MANIFEST);
  char *const words[] = {"library", "tom-12",  "-o", folder, "--velocities",
                         "1",       "--takes", "1",  NULL};
  (void)atexit(remove_folder);
  fuzz_require(arguments_read(&library_command, 8, words, &arguments) == OUTCOME_OK, "arguments");
  fuzz_require(library_request_read(&arguments, &request) == OUTCOME_OK, "a request");
  return &request;
}

static void write_file(const uint8_t *data, size_t size) {
  FILE *const file = fopen(path, "wb");
  fuzz_require(file != NULL && fwrite(data, 1, size, file) == size, "writing a manifest");
  (void)fclose(file);
}

static bool file_is(const uint8_t *data, size_t size) {
  FILE *const file = fopen(path, "rb");
  bool same = file != NULL;
  for (size_t i = 0; same && i < size; i++) same = getc(file) == data[i];
  same = same && getc(file) == EOF;
  if (file) (void)fclose(file);
  return same;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static LibraryRequest *request;
  if (!request) request = make_request();
  char message[1000] = "";
  int hold = -1;
  write_file(data, size);
  const MessageCapture before = message_capture(message, sizeof message);
  const Outcome outcome = library_manifest_claim(request, &hold);
  message_release(before);
  fuzz_require(outcome == OUTCOME_OK || message[0] != '\0', "a refusal has a reason");
  fuzz_require((outcome == OUTCOME_OK) == (hold >= 0), "a folder is held if it is taken");
  fuzz_require(file_is(data, size), "the manifest is not changed");
  if (hold >= 0) (void)close(hold);
  return 0;
}
