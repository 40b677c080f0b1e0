/* SPDX-License-Identifier: MIT */
#include "library/library_sums.h"

#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/folder.h"
#include "base/text_file.h"
#include "platform/files.h"

#define LINE_SIZE 4096 /* of file names there are at most 255 bytes */
#define DIGITS 16

/* ---- FNV-1a [Fowler, Noll, Vo] -------------------------------------------------------------- */

static uint64_t sum_of_bytes(uint64_t sum, const unsigned char *bytes, size_t count) {
  for (size_t i = 0; i < count; i++) sum = (sum ^ bytes[i]) * UINT64_C(1099511628211);
  return sum;
}

static bool sum_of_file(const char *path, uint64_t *sum) {
  unsigned char bytes[65536];
  size_t count;
  FILE *const stream = file_stream_to_read(path);
  if (!stream) return false;
  *sum = UINT64_C(14695981039346656037);
  while ((count = fread(bytes, 1, sizeof bytes, stream)) > 0) {
    *sum = sum_of_bytes(*sum, bytes, count);
  }
  const bool is_read = !ferror(stream);
  (void)fclose(stream);
  return is_read;
}

/* ---- lines ---------------------------------------------------------------------------------- */

/* The sound of this name, searched from @p from on around: lines are mostly in order. The number of
 * sounds if there is none. */
static size_t find(const LibraryPlan *plan, const char *file, size_t from) {
  for (size_t i = 0; i < plan->count; i++) {
    const size_t at = (from + i) % plan->count;
    if (strcmp(plan->sounds[at].file, file) == 0) return at;
  }
  return plan->count;
}

/* Sixteen digits, two blanks, a name. */
static const char *read_line(char *line, uint64_t *sum) {
  char *end;
  if (strspn(line, "0123456789abcdef") != DIGITS || strncmp(line + DIGITS, "  ", 2) != 0) return "";
  *sum = strtoull(line, &end, 16);
  line[strcspn(line, "\r\n")] = '\0';
  return end + 2;
}

static void read_lines(FILE *stream, LibrarySums *sums) {
  const LibraryPlan *const plan = &sums->request->plan;
  char line[LINE_SIZE];
  size_t next = 0;
  while (fgets(line, sizeof line, stream)) {
    uint64_t sum = 0;
    if (!strchr(line, '\n')) continue; /* its writer was killed */
    const size_t index = find(plan, read_line(line, &sum), next);
    if (index == plan->count) continue;
    sums->of[index] = (LibrarySum){.is_known = true, .sum = sum};
    next = index + 1;
  }
}

static int print_line(char *line, size_t size, const char *file, uint64_t sum) {
  return snprintf(line, size, "%016" PRIx64 "  %s\n", sum, file);
}

/* Lines of all known checksums; the caller frees them. */
static char *print_lines(const LibrarySums *sums) {
  const LibraryPlan *const plan = &sums->request->plan;
  size_t size = 1, length = 0;
  for (size_t i = 0; i < plan->count; i++) size += strlen(plan->sounds[i].file) + DIGITS + 4;
  char *const text = calloc(size, 1);
  for (size_t i = 0; text && i < plan->count; i++) {
    if (!sums->of[i].is_known) continue;
    length +=
      (size_t)print_line(text + length, size - length, plan->sounds[i].file, sums->of[i].sum);
  }
  return text;
}

/* ---- of a library --------------------------------------------------------------------------- */

Outcome library_sums_read(const LibraryRequest *request, LibrarySums *sums) {
  *sums = (LibrarySums){.request = request,
                        .path = folder_path(request->folder, LIBRARY_SUMS),
                        .of = calloc(request->plan.count, sizeof *sums->of),
                        .descriptor = -1};
  if (!sums->path || !sums->of) return fail_memory();
  FILE *const stream = file_stream_to_read(sums->path);
  if (!stream) return OUTCOME_OK;
  read_lines(stream, sums);
  (void)fclose(stream);
  return OUTCOME_OK;
}

void library_sums_free(LibrarySums *sums) {
  if (sums->descriptor >= 0) (void)close(sums->descriptor);
  free(sums->path);
  free(sums->of);
}

bool library_sums_keep(LibrarySums *sums, size_t index, const char *path) {
  LibrarySum *const of = &sums->of[index];
  uint64_t sum;
  const bool is_there = of->is_known && sum_of_file(path, &sum);
  of->is_known = is_there && sum == of->sum;
  if (is_there && !of->is_known && !sums->request->render.quiet) {
    note("%s: not the bytes that were written; it is rendered again", path);
  }
  return of->is_known;
}

Outcome library_sums_begin(LibrarySums *sums) {
  char *const text = print_lines(sums);
  const Outcome outcome = text ? text_file_write(sums->path, text, false) : fail_memory();
  free(text);
  if (outcome != OUTCOME_OK) return outcome;
  sums->descriptor = file_open_to_write(sums->path);
  if (sums->descriptor >= 0 && lseek(sums->descriptor, 0, SEEK_END) >= 0) return OUTCOME_OK;
  return fail("cannot write '%s': %s", sums->path, strerror(errno));
}

Outcome library_sums_add(void *context, const RenderJob *job) {
  LibrarySums *const sums = context;
  const LibraryPlan *const plan = &sums->request->plan;
  const char *const file = job->output + strlen(sums->request->folder);
  char line[LINE_SIZE];
  uint64_t sum;
  const size_t index = find(plan, file, 0);
  if (index == plan->count) return OUTCOME_OK;
  if (!sum_of_file(job->output, &sum))
    return fail("cannot read '%s': %s", job->output, strerror(errno));
  sums->of[index] = (LibrarySum){.is_known = true, .sum = sum};
  const int length = print_line(line, sizeof line, file, sum);
  if (length < (int)sizeof line && write(sums->descriptor, line, (unsigned)length) == length) {
    return OUTCOME_OK;
  }
  return fail("cannot write '%s': %s", sums->path, strerror(errno));
}

Outcome library_sums_end(LibrarySums *sums) {
  char *const text = print_lines(sums);
  if (!text) return fail_memory();
  if (sums->descriptor >= 0) (void)close(sums->descriptor);
  sums->descriptor = -1;
  const bool is_there = text_file_holds(sums->path, text);
  const Outcome outcome = is_there ? OUTCOME_OK : text_file_write(sums->path, text, false);
  free(text);
  return outcome;
}
