/* SPDX-License-Identifier: MIT */
#include "lv2/sequence.h"

#include <stddef.h>

#define ALIGNMENT 8u /* of events */

Sequence sequence_begin(const LV2_Atom_Sequence *atom, LV2_URID type) {
  const bool is_one =
    atom && atom->atom.type == type && atom->atom.size >= sizeof(LV2_Atom_Sequence_Body);
  if (!is_one) return (Sequence){NULL, NULL};
  const uint8_t *const body = (const uint8_t *)&atom->body;
  return (Sequence){body + sizeof(LV2_Atom_Sequence_Body), body + atom->atom.size};
}

static size_t left(const Sequence *sequence) { return (size_t)(sequence->end - sequence->next); }

const LV2_Atom_Event *sequence_event(const Sequence *sequence) {
  const LV2_Atom_Event *const event = (const LV2_Atom_Event *)(const void *)sequence->next;
  if (!sequence->next || left(sequence) < sizeof *event) return NULL;
  return event->body.size <= left(sequence) - sizeof *event ? event : NULL;
}

void sequence_step(Sequence *sequence) {
  const LV2_Atom_Event *const event = (const LV2_Atom_Event *)(const void *)sequence->next;
  const size_t size = sizeof *event + event->body.size;
  const size_t padded = (size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
  sequence->next = padded < left(sequence) ? sequence->next + padded : sequence->end;
}
