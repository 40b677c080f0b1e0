/* SPDX-License-Identifier: MIT */
#include "base/text_file.h"

#include <stdio.h>
#include <string.h>

#include "platform/files.h"

Outcome text_file_write(const char *path, const char *text, bool keep_existing) {
  OutputFile file;
  OutputFile *const files[] = {&file};
  Outcome outcome = output_plan(&file, path, keep_existing);
  if (outcome == OUTCOME_OK) outcome = output_open(&file, false);
  if (outcome == OUTCOME_OK) outcome = output_write(&file, text, strlen(text));
  if (outcome == OUTCOME_OK) outcome = output_complete(&file);
  if (outcome == OUTCOME_OK) outcome = output_deliver(files, 1);
  output_discard(&file);
  return outcome;
}

bool text_file_holds(const char *path, const char *text) {
  FILE *const file = file_stream_to_read(path);
  bool same = file != NULL;
  while (same && *text) same = getc(file) == (unsigned char)*text++;
  same = same && getc(file) == EOF;
  if (file) (void)fclose(file);
  return same;
}
