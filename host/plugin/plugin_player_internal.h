/* SPDX-License-Identifier: MIT */
/* Functions shared by the files of a player. Calls go one way: plugin_player.c and
   plugin_player_sound.c call plugin_player_model.c, and all three call plugin_player_input.c. */
#ifndef TABOR_PLUGIN_PLAYER_INTERNAL_H
#define TABOR_PLUGIN_PLAYER_INTERNAL_H

#include "plugin/plugin_player.h"

/* Sets all knobs to the values of the definition. */
void plugin_player_forget_turns(Request *request) REALTIME;
/* Lets @p message act now, before what MIDI has asked for. */
void plugin_player_act_now(PluginPlayer *player, const PlayerMessage *message) REALTIME;
/* Moves a live parameter of the drum now. */
void plugin_player_move_parameter(PluginPlayer *player, uint32_t id, double value) REALTIME;
/* A DrumSourceFn: the next message of a PluginPlayer. */
bool plugin_player_next(void *source, uint64_t end, PlayerMessage *message) REALTIME;
/* The value that a live knob is to have now: as MIDI says, else the knob, else the drum; and
 * modulated. */
double plugin_player_live_value(const PluginPlayer *player, KnobId id) REALTIME;
/* Sets the position of strokes, until controllers move it. */
void plugin_player_place_strokes(PluginPlayer *player) REALTIME;
/* Restores the drum's live values that differ from its model's; call after another model has come.
 */
void plugin_player_move_live(PluginPlayer *player) REALTIME;
/* Marks the drum as not chosen by MIDI. */
void plugin_player_forget_choice(PluginPlayer *player) REALTIME;

#endif
