/* SPDX-License-Identifier: MIT */
/* What the files of a player have in common. Calls go one way: plugin_player.c and plugin_player_sound.c call
   plugin_player_model.c, and all three call plugin_player_input.c. */
#ifndef TABOR_LV2_PLUGIN_PLAYER_INTERNAL_H
#define TABOR_LV2_PLUGIN_PLAYER_INTERNAL_H

#include "lv2/plugin_player.h"

#define CROSS_FADE 0.008 /* [s] of a drum that leaves and the same one, changed */

/* Knobs stand where the definition says. */
void plugin_player_forget_turns(Request *request) REALTIME;
/* Moves a live parameter of the drum at once, before what waits for it. */
void plugin_player_move_parameter(PluginPlayer *player, uint32_t id, double value) REALTIME;
/* The first @p count events, which are about to act, are what the drum is from now on. */
void plugin_player_note_events(PluginPlayer *player, uint32_t count) REALTIME;
/* The first @p count events act at once. */
void plugin_player_let_act(PluginPlayer *player, uint32_t count) REALTIME;
/* Where strokes fall, until controllers say. */
void plugin_player_place_strokes(PluginPlayer *player) REALTIME;
/* Wishes for a preset's drum. */
void plugin_player_choose_preset(PluginPlayer *player, uint32_t preset) REALTIME;
/* Does what MIDI wants beside strokes, until a silence, or with @p waits a change, that the rest has to wait for. */
void plugin_player_act_due(PluginPlayer *player, bool waits) REALTIME;
/* Gives the drum its live values, if they are not its model's; after another model has come. */
void plugin_player_move_live(PluginPlayer *player) REALTIME;
/* The drum is none that MIDI has chosen. */
void plugin_player_forget_choice(PluginPlayer *player) REALTIME;
/* For the worker to destroy; NULL is nothing. */
void plugin_player_throw_away(PluginPlayer *player, TaborDrum *drum) REALTIME;
/* What the drum was before its last swap is not needed any more. */
void plugin_player_end_crossing(PluginPlayer *player) REALTIME;
/* Throws drums away that have left. */
void plugin_player_clear_up(PluginPlayer *player) REALTIME;
/* Nothing sounds beside the drum any more. */
void plugin_player_cut_others(PluginPlayer *player) REALTIME;

#endif
