/* SPDX-License-Identifier: MIT */
#include "window/control_pages.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plugin/key_name.h"

static const char DRUM[] = "drum."; /* of keys of a kit's drums */

/* ---- keys and pages ------------------------------------------------------------------------- */

/* "drum.snare.batter" as "snare batter"; keys without a section say what the drum is. */
static void name_section(const char *key, char name[TABOR_NAME_SIZE]) {
  const size_t skipped = strncmp(key, DRUM, sizeof DRUM - 1) == 0 ? sizeof DRUM - 1 : 0;
  const size_t length = key_section(key);
  const int shown = length > skipped ? (int)(length - skipped) : 0;
  (void)snprintf(name, TABOR_NAME_SIZE - 4, "%.*s", shown, key + skipped);
  if (shown == 0) (void)snprintf(name, TABOR_NAME_SIZE, "about");
  for (char *dot = strchr(name, '.'); dot; dot = strchr(dot, '.')) *dot = ' ';
}

static uint32_t keys_of_section(const ControlPages *pages, uint32_t first) {
  uint32_t count = 1;
  while (first + count < pages->key_count &&
         key_is_same_section(pages->keys[first], pages->keys[first + count]))
    count++;
  return count;
}

/* "batter: damping 0", by its first key. */
static void name_part(char name[TABOR_NAME_SIZE], const char *key) {
  const size_t start = strlen(name) + 2;
  (void)snprintf(name + start - 2, TABOR_NAME_SIZE - start + 2, ": ");
  (void)key_title(key, name + start, TABOR_NAME_SIZE - start);
}

static void add_section(ControlPages *pages, uint32_t first, uint32_t count) {
  for (uint32_t done = 0; done < count; done += KNOB_PAGE) {
    KeyPage *const page = &pages->pages[pages->page_count++];
    page->first = first + done;
    page->count = count - done < KNOB_PAGE ? count - done : KNOB_PAGE;
    name_section(pages->keys[first], page->name);
    if (count > KNOB_PAGE) name_part(page->name, pages->keys[page->first]);
  }
}

static void count_key(void *context, const char *key) {
  (void)key;
  ++*(uint32_t *)context;
}

static void take_key(void *context, const char *key) {
  ControlPages *const pages = context;
  (void)snprintf(pages->keys[pages->key_count++], DEFINITION_KEY, "%s", key);
}

static bool make_room(ControlPages *pages, uint32_t count) {
  free(pages->keys);
  free(pages->pages);
  pages->key_count = pages->page_count = 0;
  pages->keys = malloc((count + 1) * sizeof *pages->keys);
  pages->pages = malloc((count + 1) * sizeof *pages->pages); /* no more than keys */
  return pages->keys && pages->pages;
}

static uint32_t knob_pages_of(const ControlPages *pages) {
  uint32_t count = 0;
  while (instrument_page(pages->kind, count)) count++;
  return count;
}

static uint32_t page_named(const ControlPages *pages, const char *name) {
  const uint32_t knobs = knob_pages_of(pages);
  uint32_t found = 0;
  while (found < pages->page_count && strcmp(pages->pages[found].name, name) != 0) found++;
  return found < pages->page_count ? knobs + found : 0;
}

bool control_pages_fill(ControlPages *pages, const Definition *definition) {
  uint32_t count = 0;
  char name[TABOR_NAME_SIZE];
  const bool is_of_keys = !control_pages_knobs(pages);
  (void)snprintf(name, sizeof name, "%s", control_pages_name(pages));
  const bool has_room = definition_visit(definition, count_key, &count) &&
                        make_room(pages, count) && definition_visit(definition, take_key, pages);
  for (uint32_t i = 0, keys; i < pages->key_count; i += keys) {
    keys = keys_of_section(pages, i);
    add_section(pages, i, keys);
  }
  if (is_of_keys) pages->at = page_named(pages, name);
  return has_room;
}

void control_pages_end(ControlPages *pages) {
  free(pages->keys);
  free(pages->pages);
}

/* ---- the page that is shown ----------------------------------------------------------------- */

static const KeyPage *key_page(const ControlPages *pages) {
  const uint32_t knobs = knob_pages_of(pages);
  return pages->at >= knobs && pages->at - knobs < pages->page_count
           ? &pages->pages[pages->at - knobs]
           : NULL;
}

void control_pages_turn(ControlPages *pages, int steps) {
  const int count = (int)(knob_pages_of(pages) + pages->page_count);
  pages->at = (uint32_t)((((int)pages->at + steps) % count + count) % count);
}

const char *control_pages_name(const ControlPages *pages) {
  const KnobPage *const knobs = control_pages_knobs(pages);
  const KeyPage *const keys = key_page(pages);
  if (knobs) return knobs->name;
  return keys ? keys->name : "";
}

const KnobPage *control_pages_knobs(const ControlPages *pages) {
  return instrument_page(pages->kind, pages->at);
}

const char *control_pages_key(const ControlPages *pages, uint32_t place) {
  const KeyPage *const page = key_page(pages);
  return page && place < page->count ? pages->keys[page->first + place] : NULL;
}

/* ---- the list ------------------------------------------------------------------------------- */

/* "tension, pitch, surface density" */
static void name_keys(const ControlPages *pages, const KeyPage *page, char *text, size_t size) {
  size_t length = 0;
  text[0] = '\0';
  for (uint32_t i = 0; i < page->count && length < size; i++) {
    if (i > 0) length += (size_t)snprintf(text + length, size - length, ", ");
    if (length < size)
      length += (size_t)key_title(pages->keys[page->first + i], text + length, size - length);
  }
}

static void name_knobs(const ControlPages *pages, const KnobPage *page, char *text, size_t size) {
  const uint32_t count = pages->kind->knob_count;
  size_t length = 0;
  uint32_t id;
  text[0] = '\0';
  for (uint32_t i = 0;
       (id = instrument_knob_on_page(pages->kind, page, i)) < count && length < size; i++)
    length += (size_t)snprintf(text + length, size - length, "%s%s", i > 0 ? ", " : "",
                               pages->kind->knobs[id].name);
}

void control_pages_list(const ControlPages *pages, ListView *list) {
  char text[TABOR_TEXT_SIZE];
  const uint32_t knobs = knob_pages_of(pages);
  ListLine *line;
  list_view_clear(list);
  list_view_add_category(list, "for playing, and known to the host");
  for (uint32_t i = 0; i < knobs; i++) {
    const KnobPage *const page = instrument_page(pages->kind, i);
    name_knobs(pages, page, text, sizeof text);
    if ((line = list_view_add(list, page->name, text))) line->number = i;
  }
  list_view_add_category(list, "all parameters");
  for (uint32_t i = 0; i < pages->page_count; i++) {
    name_keys(pages, &pages->pages[i], text, sizeof text);
    if ((line = list_view_add(list, pages->pages[i].name, text))) line->number = knobs + i;
  }
}
