/* SPDX-License-Identifier: MIT */
/* The reader of Standard MIDI Files against another one, libsmf: messages and times of random
 * files. */
#include "midi/midi_file_input.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "midi_writer.h"
#include "said.h"

#ifdef TABOR_HAVE_SMF
#  include <smf.h>

#  define FILES 300

/* libsmf adds up segments in another order of rounding. */
static const double ROUNDING = 1e-10; /* relative */

static MidiWriter writer;
static MidiFile file;

/* The next channel message, or NULL. */
static const smf_event_t *next_message(smf_t *smf) {
  const smf_event_t *event;
  while ((event = smf_get_next_event(smf)) != NULL) {
    if (event->midi_buffer[0] < 0xF0) return event;
  }
  return NULL;
}

static void compare(uint64_t seed, size_t index, const smf_event_t *theirs) {
  const MidiFileEvent *const ours = &file.events[index];
  const int count = 1 + midi_data_count(ours->message.status);
  const uint8_t bytes[] = {ours->message.status, ours->message.data[0], ours->message.data[1]};
  if (theirs->midi_buffer_length != count ||
      memcmp(theirs->midi_buffer, bytes, (size_t)count) != 0) {
    fail_msg("file %llu, message %zu: other bytes", (unsigned long long)seed, index);
  }
  if (!(fabs(ours->time - theirs->time_seconds) <= ROUNDING * (1 + theirs->time_seconds))) {
    fail_msg("file %llu, message %zu: at %.17g s, not %.17g", (unsigned long long)seed, index,
             ours->time, theirs->time_seconds);
  }
}

static void test_random_files(void **state) {
  (void)state;
  size_t messages = 0;
  for (uint64_t seed = 1; seed <= FILES; seed++) {
    midi_write_random(&writer, seed);
    if (midi_file_parse("song.mid", writer.bytes, writer.length, false, &file) != OUTCOME_OK)
      fail_msg("%s", said);
    smf_t *const smf = smf_load_from_memory(writer.bytes, (int)writer.length);
    assert_non_null(smf);
    smf_rewind(smf);
    const smf_event_t *theirs;
    size_t index = 0;
    for (; (theirs = next_message(smf)) != NULL; index++) {
      if (index >= file.count)
        fail_msg("file %llu: messages are missing", (unsigned long long)seed);
      compare(seed, index, theirs);
    }
    assert_int_equal(index, file.count);
    messages += file.count;
    smf_delete(smf);
    midi_file_free(&file);
  }
  printf("seeds 1 to %d: %zu messages\n", FILES, messages);
  assert_true(messages > 10 * FILES);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_random_files)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}

#else

int main(void) {
  puts("SKIPPED: needs libsmf-dev");
  return 77;
}

#endif
