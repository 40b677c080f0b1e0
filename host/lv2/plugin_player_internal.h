/* SPDX-License-Identifier: MIT */
/* Functions shared by the files of a player. Calls go one way: plugin_player.c and plugin_player_sound.c call
   plugin_player_model.c, and all three call plugin_player_input.c. */
#ifndef TABOR_LV2_PLUGIN_PLAYER_INTERNAL_H
#define TABOR_LV2_PLUGIN_PLAYER_INTERNAL_H

#include "lv2/plugin_player.h"

#define CROSS_FADE 0.008 /* crossfade from the drum before a swap to the drum after it [s] */

/* Sets all knobs to the values of the definition. */
void plugin_player_forget_turns(Request *request) REALTIME;
/* Moves a live parameter of the drum at once, before all waiting events. */
void plugin_player_move_parameter(PluginPlayer *player, uint32_t id, double value) REALTIME;
/* Records the values that the first @p count events are about to give the drum. */
void plugin_player_note_events(PluginPlayer *player, uint32_t count) REALTIME;
/* Makes the first @p count events act at once. */
void plugin_player_let_act(PluginPlayer *player, uint32_t count) REALTIME;
/* Sets the position of strokes, until controllers move it. */
void plugin_player_place_strokes(PluginPlayer *player) REALTIME;
/* Requests the drum of a preset. */
void plugin_player_choose_preset(PluginPlayer *player, uint32_t preset) REALTIME;
/* Executes the due MIDI actions, up to and including a silence or, with @p waits, a change of preset. */
void plugin_player_act_due(PluginPlayer *player, bool waits) REALTIME;
/* Restores the drum's live values that differ from its model's; call after another model has come. */
void plugin_player_move_live(PluginPlayer *player) REALTIME;
/* Marks the drum as not chosen by MIDI. */
void plugin_player_forget_choice(PluginPlayer *player) REALTIME;
/* Leaves @p drum to the worker, which destroys it; NULL is allowed. */
void plugin_player_throw_away(PluginPlayer *player, TaborDrum *drum) REALTIME;
/* Ends the crossfade of the last swap and discards the old drum. */
void plugin_player_end_crossing(PluginPlayer *player) REALTIME;
/* Leaves drums whose fade has ended to the worker. */
void plugin_player_clear_up(PluginPlayer *player) REALTIME;
/* Silences every drum but the current one. */
void plugin_player_cut_others(PluginPlayer *player) REALTIME;

#endif
