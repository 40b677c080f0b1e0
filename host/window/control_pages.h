/* SPDX-License-Identifier: MIT */
/**
 * @file control_pages.h
 * The pages of controls of a window: those of the instrument's knobs, then all parameters of the
 * drum or kit, section by section. MAIN: all functions.
 */
#ifndef TABOR_WINDOW_CONTROL_PAGES_H
#define TABOR_WINDOW_CONTROL_PAGES_H

#include "plugin/instrument.h"
#include "window/list_view.h"

/** A page of parameters: consecutive keys of one section. */
typedef struct KeyPage {
  char name[TABOR_NAME_SIZE];
  uint32_t first, count; /**< of the keys */
} KeyPage;

/** Begins with zeros. */
typedef struct ControlPages {
  const InstrumentKind *kind;
  char (*keys)[DEFINITION_KEY];
  uint32_t key_count;
  KeyPage *pages;
  uint32_t page_count;
  uint32_t at; /**< the page that is shown: those of knobs come first */
} ControlPages;

void control_pages_end(ControlPages *pages);
/** Lists the keys of a definition anew; the page that was shown stays, if there is one of its name.
 * False if memory is short: then there are pages of knobs alone. */
bool control_pages_fill(ControlPages *pages, const Definition *definition);
/** Turns over @p steps pages; the first follows the last. */
void control_pages_turn(ControlPages *pages, int steps);
/** Name of the page that is shown. */
const char *control_pages_name(const ControlPages *pages);
/** The page of knobs that is shown; NULL: it is one of parameters. */
const KnobPage *control_pages_knobs(const ControlPages *pages);
/** Key number @p place of the page; NULL past its last, or if it is one of knobs. */
const char *control_pages_key(const ControlPages *pages, uint32_t place);
/** Fills the list of pages; the number of a line is its page. */
void control_pages_list(const ControlPages *pages, ListView *list);

#endif
