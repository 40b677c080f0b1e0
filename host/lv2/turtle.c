/* SPDX-License-Identifier: MIT */
#include "lv2/turtle.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static FILE *file; /* that is being written */

void turtle_fail(const char *what) {
  (void)fprintf(stderr, "describe: %s\n", what);
  exit(1);
}

void put(const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  if (vfprintf(file, format, arguments) < 0) turtle_fail("cannot write");
  va_end(arguments);
}

void put_text(const char *text) {
  put("\"");
  for (; *text; text++) {
    switch (*text) {
    case '\n': put("\\n"); break;
    case '"': put("\\\""); break;
    case '\\': put("\\\\"); break;
    default: put("%c", *text);
    }
  }
  put("\"");
}

void put_number(double value) {
  char text[64];
  (void)snprintf(text, sizeof text, "%.6g", value);
  if (strchr(text, 'e')) (void)snprintf(text, sizeof text, "%.1f", value);
  put("%s%s", text, strchr(text, '.') ? "" : ".0");
}

void turtle_open(const char *folder, const char *name) {
  char path[4096];
  (void)snprintf(path, sizeof path, "%s/%s", folder, name);
  file = fopen(path, "w");
  if (!file) turtle_fail(path);
  put("# SPDX-License-"
      "Identifier: MIT\n");
}

void turtle_close(void) {
  if (fclose(file) != 0) turtle_fail("cannot write");
}

void put_prefixes(void) {
  put("@prefix atom: <http://lv2plug.in/ns/ext/atom#> .\n"
      "@prefix doap: <http://usefulinc.com/ns/doap#> .\n"
      "@prefix foaf: <http://xmlns.com/foaf/0.1/> .\n"
      "@prefix log: <http://lv2plug.in/ns/ext/log#> .\n"
      "@prefix lv2: <http://lv2plug.in/ns/lv2core#> .\n"
      "@prefix midi: <http://lv2plug.in/ns/ext/midi#> .\n"
      "@prefix owl: <http://www.w3.org/2002/07/owl#> .\n"
      "@prefix param: <http://lv2plug.in/ns/ext/parameters#> .\n"
      "@prefix patch: <http://lv2plug.in/ns/ext/patch#> .\n"
      "@prefix pg: <http://lv2plug.in/ns/ext/port-groups#> .\n"
      "@prefix pprops: <http://lv2plug.in/ns/ext/port-props#> .\n"
      "@prefix pset: <http://lv2plug.in/ns/ext/presets#> .\n"
      "@prefix rdf: <http://www.w3.org/1999/02/22-rdf-syntax-ns#> .\n"
      "@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .\n"
      "@prefix state: <http://lv2plug.in/ns/ext/state#> .\n"
      "@prefix ui: <http://lv2plug.in/ns/extensions/ui#> .\n"
      "@prefix units: <http://lv2plug.in/ns/extensions/units#> .\n"
      "@prefix urid: <http://lv2plug.in/ns/ext/urid#> .\n"
      "@prefix work: <http://lv2plug.in/ns/ext/worker#> .\n"
      "@prefix xsd: <http://www.w3.org/2001/XMLSchema#> .\n\n");
}
