/* SPDX-License-Identifier: MIT */
/*
 * embed-presets OUT.c A.ini B.ini ...: writes preset files as the C table of engine/src/preset.h,
 * in this order. Part of the build, not of the product. What the values are worth is tested later
 * (tests/engine/test_preset.c); here a file only has to be a sound INI file.
 */
#include "drums/preset_file.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The file being written, and what is known of the preset at hand. */
typedef struct Writer {
  FILE *out;
  unsigned pair_count;
  char comment[256];
} Writer;

/* As a C string: whatever could mean something to the compiler goes as an octal escape. */
static void write_string(FILE *out, const char *text) {
  putc('"', out);
  for (; *text; text++) {
    const unsigned char c = (unsigned char)*text;
    if (c < 0x20 || c > 0x7E || c == '"' || c == '\\' || c == '?') { /* '?': trigraphs */
      fprintf(out, "\\%03o", c);
    } else {
      putc(c, out);
    }
  }
  putc('"', out);
}

static bool write_pair(void *context, const char *section, const char *key, const char *value,
                       unsigned line, char *message, size_t size) {
  Writer *const writer = context;
  char full[128];
  (void)line;
  writer->pair_count++;
  if (!key) {
    fputs("  {", writer->out);
    write_string(writer->out, section);
    fputs(", NULL},\n", writer->out);
    return true;
  }
  if (snprintf(full, sizeof full, "%s.%s", section, key) >= (int)sizeof full) {
    (void)snprintf(message, size, "the key '%s' is too long", key);
    return false;
  }
  if (strcmp(full, "drum.comment") == 0) {
    (void)snprintf(writer->comment, sizeof writer->comment, "%s", value);
  }
  fputs("  {", writer->out);
  write_string(writer->out, full);
  fputs(", ", writer->out);
  write_string(writer->out, value);
  fputs("},\n", writer->out);
  return true;
}

static const char *file_name(const char *path) {
  const char *const slash = strrchr(path, '/');
  return slash ? slash + 1 : path;
}

/* "presets/frame-drum.ini" to "frame-drum". */
static void preset_name(const char *path, char *name, size_t size) {
  (void)snprintf(name, size, "%s", file_name(path));
  char *const dot = strrchr(name, '.');
  if (dot) *dot = '\0';
}

static bool write_preset(FILE *out, const char *path, unsigned index, Writer *writer) {
  char message[512];
  *writer = (Writer){.out = out};
  fprintf(out, "\nstatic const TbPresetPair pairs_%u[] = {\n", index);
  if (preset_file_read(path, write_pair, writer, message, sizeof message) != PRESET_FILE_OK) {
    fprintf(stderr, "embed-presets: %s\n", message);
    return false;
  }
  fputs("};\n", out);
  return true;
}

static void write_row(FILE *out, const char *path, unsigned index, const Writer *writer) {
  char name[256];
  preset_name(path, name, sizeof name);
  fputs("  {{", out);
  write_string(out, name);
  fputs(", ", out);
  write_string(out, writer->comment);
  fputs(", ", out);
  write_string(out, file_name(path));
  fprintf(out, "}, pairs_%u, %u},\n", index, writer->pair_count);
}

static bool write_table(FILE *out, char **paths, unsigned count) {
  Writer *const writers = calloc(count, sizeof *writers);
  bool good = writers != NULL;
  fputs("/* Written by embed-presets from the files of presets/. */\n#include "
        "\"preset.h\"\n#include <stddef.h>\n",
        out);
  for (unsigned i = 0; good && i < count; i++) good = write_preset(out, paths[i], i, &writers[i]);
  fputs("\nconst TbPreset tb_presets[] = {\n", out);
  for (unsigned i = 0; good && i < count; i++) write_row(out, paths[i], i, &writers[i]);
  fprintf(out, "};\n\nconst uint32_t tb_preset_count = %u;\n", count);
  free(writers);
  return good;
}

int main(int argc, char **argv) {
  if (argc < 3) {
    fputs("usage: embed-presets OUT.c PRESET.ini ...\n", stderr);
    return 2;
  }
  FILE *const out = fopen(argv[1], "w");
  if (!out) {
    perror(argv[1]);
    return 1;
  }
  bool good = write_table(out, argv + 2, (unsigned)argc - 2u);
  if (ferror(out) || fclose(out) != 0) {
    perror(argv[1]);
    good = false;
  }
  if (!good) (void)remove(argv[1]); /* half a table must not look like a finished one */
  return good ? 0 : 1;
}
