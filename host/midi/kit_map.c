/* SPDX-License-Identifier: MIT */
#include "midi/kit_map.h"

#include <string.h>

#define AS_IN_KIT MIDI_STROKE_NONE
#define RIMSHOT MIDI_STROKE_RIMSHOT
#define CROSS_STICK MIDI_STROKE_CROSS_STICK
#define RIM MIDI_STROKE_RIM
#define BELL MIDI_STROKE_BELL
#define BOW MIDI_STROKE_BOW
#define EDGE MIDI_STROKE_EDGE

/* [RolandTD17], factory setting. */
static const KitMapNote roland[] = {
  {36, 36, AS_IN_KIT},   /* kick */
  {38, 38, AS_IN_KIT},   /* snare, head */
  {40, 38, RIMSHOT},     /* snare, rim */
  {37, 38, CROSS_STICK}, /* snare, cross-stick */
  {48, 48, AS_IN_KIT},   /* tom 1 */
  {50, 48, RIMSHOT},     /* tom 1, rim */
  {45, 45, AS_IN_KIT},   /* tom 2 */
  {47, 45, RIMSHOT},     /* tom 2, rim */
  {43, 43, AS_IN_KIT},   /* tom 3 */
  {58, 43, RIMSHOT},     /* tom 3, rim */
  {46, 46, AS_IN_KIT},   /* open hi-hat, bow */
  {26, 46, AS_IN_KIT},   /* open hi-hat, edge */
  {42, 42, AS_IN_KIT},   /* closed hi-hat, bow */
  {22, 42, AS_IN_KIT},   /* closed hi-hat, edge */
  {44, 44, AS_IN_KIT},   /* hi-hat, pedal */
  {49, 49, BOW},         /* crash 1, bow */
  {55, 49, EDGE},        /* crash 1, edge */
  {57, 57, BOW},         /* crash 2, bow */
  {52, 57, EDGE},        /* crash 2, edge */
  {51, 51, AS_IN_KIT},   /* ride, bow */
  {59, 51, EDGE},        /* ride, edge */
  {53, 53, AS_IN_KIT},   /* ride, bell */
};

/* [YamahaDTX502], preset kits 1 to 49. "Snare (off)" is the snare drum; its strainer stays as it
 * is. */
static const KitMapNote yamaha[] = {
  {36, 36, AS_IN_KIT},   /* kick 1 */
  {35, 35, AS_IN_KIT},   /* kick 2 */
  {38, 38, AS_IN_KIT},   /* snare, head */
  {40, 38, RIMSHOT},     /* snare, open rim */
  {37, 38, CROSS_STICK}, /* snare, closed rim */
  {31, 38, AS_IN_KIT},   /* snare (off), head */
  {34, 38, RIMSHOT},     /* snare (off), open rim */
  {27, 38, CROSS_STICK}, /* snare (off), closed rim */
  {48, 48, AS_IN_KIT},   /* tom 1 */
  {47, 47, AS_IN_KIT},   /* tom 2 */
  {43, 43, AS_IN_KIT},   /* tom 3 */
  {46, 46, AS_IN_KIT},   /* open hi-hat */
  {78, 46, AS_IN_KIT},   /* open hi-hat, edge */
  {85, 46, AS_IN_KIT},   /* open hi-hat, cup */
  {42, 42, AS_IN_KIT},   /* closed hi-hat */
  {79, 42, AS_IN_KIT},   /* closed hi-hat, edge */
  {86, 42, AS_IN_KIT},   /* closed hi-hat, cup */
  {44, 44, AS_IN_KIT},   /* hi-hat closed by the foot */
  {83, 46, AS_IN_KIT},   /* splash by the foot; 46 in the module's own General MIDI kit */
  {59, 49, BOW},         /* crash, bow */
  {49, 49, EDGE},        /* crash, edge */
  {55, 49, BELL},        /* crash, cup */
  {51, 51, AS_IN_KIT},   /* ride, bow */
  {52, 51, EDGE},        /* ride, edge */
  {53, 53, AS_IN_KIT},   /* ride, cup */
};

/* [AlesisNitro], factory setting. */
static const KitMapNote alesis[] = {
  {36, 36, AS_IN_KIT}, /* kick */
  {38, 38, AS_IN_KIT}, /* snare */
  {40, 38, RIMSHOT},   /* snare, rim */
  {48, 48, AS_IN_KIT}, /* tom 1 */
  {50, 48, RIMSHOT},   /* tom 1, rim */
  {45, 45, AS_IN_KIT}, /* tom 2 */
  {47, 45, RIMSHOT},   /* tom 2, rim */
  {43, 43, AS_IN_KIT}, /* tom 3 */
  {58, 43, RIMSHOT},   /* tom 3, rim */
  {41, 41, AS_IN_KIT}, /* tom 4 */
  {39, 41, RIMSHOT},   /* tom 4, rim */
  {46, 46, AS_IN_KIT}, /* open hi-hat */
  {23, 46, AS_IN_KIT}, /* hi-hat half open */
  {42, 42, AS_IN_KIT}, /* closed hi-hat */
  {44, 44, AS_IN_KIT}, /* hi-hat, pedal */
  {21, 46, AS_IN_KIT}, /* hi-hat, splash */
  {49, 49, AS_IN_KIT}, /* crash 1 */
  {57, 57, AS_IN_KIT}, /* crash 2 */
  {51, 51, AS_IN_KIT}, /* ride */
};

/* [SuperiorDrummer3]: one program's list, less the notes on which another one contradicts it; 50,
 * 54, 56, 58 and 83 mute cymbals. */
static const KitMapNote superior[] = {
  {36, 36, AS_IN_KIT},   /* kick */
  {38, 38, AS_IN_KIT},   /* snare */
  {40, 38, RIMSHOT},     /* snare, rimshot */
  {37, 38, CROSS_STICK}, /* snare, sidestick */
  {48, 48, AS_IN_KIT},   /* rack tom 1 */
  {82, 48, RIMSHOT},     /* rack tom 1, rimshot */
  {47, 47, AS_IN_KIT},   /* rack tom 2 */
  {45, 45, AS_IN_KIT},   /* rack tom 3 */
  {43, 43, AS_IN_KIT},   /* floor tom 1 */
  {75, 43, RIMSHOT},     /* floor tom 1, rimshot */
  {41, 41, AS_IN_KIT},   /* floor tom 2 */
  {73, 41, RIMSHOT},     /* floor tom 2, rimshot */
  {62, 42, AS_IN_KIT},   /* tight hi-hat, edge */
  {63, 42, AS_IN_KIT},   /* tight hi-hat, tip */
  {22, 42, AS_IN_KIT},   /* closed hi-hat, edge */
  {42, 42, AS_IN_KIT},   /* closed hi-hat, tip */
  {24, 46, AS_IN_KIT},   /* hi-hat, open 1 */
  {25, 46, AS_IN_KIT},   /* hi-hat, open 2 */
  {26, 46, AS_IN_KIT},   /* hi-hat, open 3 */
  {60, 46, AS_IN_KIT},   /* hi-hat, open 4 */
  {17, 46, AS_IN_KIT},   /* hi-hat, open 5 */
  {21, 44, AS_IN_KIT},   /* hi-hat closed by the pedal */
  {55, 49, AS_IN_KIT},   /* crash 1 */
  {49, 57, AS_IN_KIT},   /* crash 2 */
  {57, 49, AS_IN_KIT},   /* crash 3 */
  {52, 52, AS_IN_KIT},   /* crash 4, or a Chinese cymbal */
  {51, 51, AS_IN_KIT},   /* ride, bow */
  {59, 51, EDGE},        /* ride, edge */
  {53, 53, AS_IN_KIT},   /* ride, bell */
};

/* [AddictiveDrums2]. Its hi-hats 7 to 9 open by a controller, which a note alone does not tell. */
static const KitMapNote addictive[] = {
  {36, 36, AS_IN_KIT},   /* kick */
  {38, 38, AS_IN_KIT},   /* snare, open hit */
  {40, 38, AS_IN_KIT},   /* snare, open hit again */
  {43, 38, AS_IN_KIT},   /* snare, shallow hit */
  {6, 38, AS_IN_KIT},    /* snare, its place by a controller */
  {37, 38, RIMSHOT},     /* snare, rimshot */
  {39, 38, RIMSHOT},     /* snare, rimshot again */
  {41, 38, RIMSHOT},     /* snare, shallow rimshot */
  {42, 38, CROSS_STICK}, /* snare, sidestick */
  {44, 38, RIM},         /* snare, rim click */
  {71, 48, AS_IN_KIT},   /* tom 1 */
  {72, 48, RIMSHOT},     /* tom 1, rimshot */
  {69, 45, AS_IN_KIT},   /* tom 2 */
  {70, 45, RIMSHOT},     /* tom 2, rimshot */
  {67, 43, AS_IN_KIT},   /* tom 3 */
  {68, 43, RIMSHOT},     /* tom 3, rimshot */
  {65, 41, AS_IN_KIT},   /* tom 4 */
  {66, 41, RIMSHOT},     /* tom 4, rimshot */
  {48, 44, AS_IN_KIT},   /* hi-hat closed by the pedal */
  {59, 46, AS_IN_KIT},   /* hi-hat opened by the pedal */
  {49, 42, AS_IN_KIT},   /* hi-hat, closed 1, tip */
  {50, 42, AS_IN_KIT},   /* hi-hat, closed 1, shaft */
  {51, 42, AS_IN_KIT},   /* hi-hat, closed 2, tip */
  {52, 42, AS_IN_KIT},   /* hi-hat, closed 2, shaft */
  {53, 42, AS_IN_KIT},   /* closed hi-hat, bell */
  {54, 46, AS_IN_KIT},   /* hi-hat, open A */
  {55, 46, AS_IN_KIT},   /* hi-hat, open B */
  {56, 46, AS_IN_KIT},   /* hi-hat, open C */
  {57, 46, AS_IN_KIT},   /* hi-hat, open D */
  {58, 46, AS_IN_KIT},   /* open hi-hat, bell */
  {60, 51, AS_IN_KIT},   /* ride 1, tip */
  {45, 51, AS_IN_KIT},   /* ride 1, tip again */
  {62, 51, AS_IN_KIT},   /* ride 1, shaft */
  {61, 53, AS_IN_KIT},   /* ride 1, bell */
  {84, 59, AS_IN_KIT},   /* ride 2, tip */
  {86, 59, AS_IN_KIT},   /* ride 2, shaft */
  {85, 53, AS_IN_KIT},   /* ride 2, bell */
  {77, 49, AS_IN_KIT},   /* cymbal 1 */
  {46, 49, AS_IN_KIT},   /* cymbal 1 again */
  {79, 57, AS_IN_KIT},   /* cymbal 2 */
  {81, 49, AS_IN_KIT},   /* cymbal 3 */
  {89, 57, AS_IN_KIT},   /* cymbal 4 */
  {91, 49, AS_IN_KIT},   /* cymbal 5 */
  {93, 57, AS_IN_KIT},   /* cymbal 6 */
};

#define MAP(array)                                                                                 \
  { #array, array, sizeof(array) / sizeof *(array) }

const KitMap kit_maps[] = {MAP(roland), MAP(yamaha), MAP(alesis), MAP(superior), MAP(addictive)};
const size_t kit_map_count = sizeof kit_maps / sizeof *kit_maps;

const KitMap *kit_map_find(const char *name) {
  for (size_t i = 0; i < kit_map_count; i++) {
    if (strcmp(kit_maps[i].name, name) == 0) return &kit_maps[i];
  }
  return NULL;
}

void kit_map_table(const KitMap *map, KitMapNote table[MIDI_VALUES]) {
  for (int note = 0; note < MIDI_VALUES; note++) {
    const uint8_t general = map ? KIT_MAP_NOTHING : (uint8_t)note;
    table[note] = (KitMapNote){.note = (uint8_t)note, .general = general};
  }
  for (size_t i = 0; map && i < map->count; i++) table[map->notes[i].note] = map->notes[i];
}
