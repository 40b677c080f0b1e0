/* SPDX-License-Identifier: MIT */
/* What the files of a voice have in common. Calls go one way: plugin_player.c and plugin_player_sound.c call plugin_player_model.c, and
   all three call plugin_player_input.c. */
#ifndef TABOR_LV2_VOICE_INSIDE_H
#define TABOR_LV2_VOICE_INSIDE_H

#include "lv2/plugin_player.h"

#define CROSS_FADE 0.008 /* [s] of a drum that leaves and the same one, changed */

/* Knobs stand where the definition says. */
void voice_forget_turns(Wish *wish) REALTIME;
/* Moves a live parameter of the drum at once, before what waits for it. */
void voice_move_parameter(Voice *voice, uint32_t id, double value) REALTIME;
/* The first @p count events, which are about to act, are what the drum is from now on. */
void voice_note_events(Voice *voice, uint32_t count) REALTIME;
/* The first @p count events act at once. */
void voice_let_act(Voice *voice, uint32_t count) REALTIME;
/* Where strokes fall, until controllers say. */
void voice_place_strokes(Voice *voice) REALTIME;
/* Wishes for a preset's drum. */
void voice_choose_preset(Voice *voice, uint32_t preset) REALTIME;
/* Does what MIDI wants beside strokes, until a silence, or with @p waits a change, that the rest has to wait for. */
void voice_act_due(Voice *voice, bool waits) REALTIME;
/* Gives the drum its live values, if they are not its model's; after another model has come. */
void voice_move_live(Voice *voice) REALTIME;
/* The drum is none that MIDI has chosen. */
void voice_forget_choice(Voice *voice) REALTIME;
/* For the worker to destroy; NULL is nothing. */
void voice_throw_away(Voice *voice, TaborDrum *drum) REALTIME;
/* What the drum was before its last swap is not needed any more. */
void voice_end_crossing(Voice *voice) REALTIME;
/* Throws drums away that have left. */
void voice_clear_up(Voice *voice) REALTIME;
/* Nothing sounds beside the drum any more. */
void voice_cut_others(Voice *voice) REALTIME;

#endif
