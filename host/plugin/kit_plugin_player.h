/* SPDX-License-Identifier: MIT */
/**
 * @file kit_plugin_player.h
 * The audio side of the plugin Tabor Kit: messages and knobs at their frames become events of the
 * kit, whose mix and drums fill a host's block. A kit that is tuned or stands in another room goes
 * on with the drums that ring, and what is not in it any more, as the sound in the room of before,
 * rings out beside it. Another kit plays anew, and the one before fades out beside it.
 */
#ifndef TABOR_PLUGIN_KIT_PLUGIN_PLAYER_H
#define TABOR_PLUGIN_KIT_PLUGIN_PLAYER_H

#include "plugin/kit_worker.h"
#include "plugin/plugin_buffers.h"
#include "plugin/window_link.h"

/** most events at once; further ones wait until these are played */
#define KIT_PLUGIN_EVENTS 1024
#define KIT_PLUGIN_PIECE 256 /**< most frames at once */

typedef struct KitPluginPlayer {
  KitWorker *worker;
  KitVoice *now, *leaving;           /**< leaving: is heard beside it */
  bool rings;                        /**< the one that leaves rings out; else it fades */
  uint32_t fade, fade_frames;        /**< frames that are left of the fade, and all */
  float values[KIT_KNOB_COUNT];      /**< of the knobs */
  float asked[KIT_KNOB_COUNT];       /**< of the newest request */
  float playing[KIT_KNOB_COUNT];     /**< of the request whose kit plays */
  unsigned own_asked, own_playing;   /**< versions of the own kit in them */
  bool has_asked;                    /**< a request was answered or is under way */
  bool exports;                      /**< the host renders, and waits for kits */
  double midi_gain[TABOR_KIT_DRUMS]; /**< by controllers, factor */
  Humanizer humanizer;
  TaborKitEvent events[KIT_PLUGIN_EVENTS];
  uint32_t event_count;
  float struck[TABOR_KIT_DRUMS]; /**< speed of the fastest stroke since it was asked for [m/s] */

  const PluginBuffers *buffers; /**< of the block: the mix in stereo, then the part of each drum in
                                   it, without the room */
  uint32_t at;                  /**< frames of it that were played */
  float sound[PLUGIN_CHANNELS][KIT_PLUGIN_PIECE]; /**< of the kit that leaves */
} KitPluginPlayer;

/** SET-UP. All knobs are at their defaults, and no kit is there yet. */
void kit_plugin_player_begin(KitPluginPlayer *player, KitWorker *worker);
/** SET-UP. Destroys its kits. */
void kit_plugin_player_end(KitPluginPlayer *player);

/* AUDIO */

/** Begins a block. */
void kit_plugin_player_begin_block(KitPluginPlayer *player, const PluginBuffers *buffers) REALTIME;
/** Turns a knob, at the next frame that is played. */
void kit_plugin_player_turn(KitPluginPlayer *player, KitKnobId id, float value) REALTIME;
/** Takes a message at frame @p frame of the block, not before a frame that was given or played
 * before. */
void kit_plugin_player_take(KitPluginPlayer *player, const MidiMessage *message,
                            uint32_t frame) REALTIME;
/** Strikes a drum at the next frame that is played. */
void kit_plugin_player_strike(KitPluginPlayer *player, const WindowStroke *stroke) REALTIME;
/** Speed of each drum's fastest stroke since the last call, 0: none. */
void kit_plugin_player_struck(KitPluginPlayer *player, float struck[TABOR_KIT_DRUMS]) REALTIME;
/** Silences the drum that @p key plays, or with a negative key all, at frame @p frame. */
void kit_plugin_player_choke(KitPluginPlayer *player, int key, uint32_t frame) REALTIME;
/** Plays up to frame @p end of the block. */
void kit_plugin_player_play(KitPluginPlayer *player, uint32_t end) REALTIME;
/** Says whether the host exports: in real time no quality is above PLUGIN_LIVE_QUALITY. */
void kit_plugin_player_export(KitPluginPlayer *player, bool exports) REALTIME;
/** Takes what the worker has built. */
void kit_plugin_player_receive(KitPluginPlayer *player) REALTIME;
/** Asks for what the knobs want. True: a worker has to run now. */
bool kit_plugin_player_ask(KitPluginPlayer *player) REALTIME;
/** A kit that leaves makes room at once. */
void kit_plugin_player_end_leaving(KitPluginPlayer *player) REALTIME;
/** True if the kit is the one that the knobs want, or that cannot be built. */
bool kit_plugin_player_is_settled(const KitPluginPlayer *player) REALTIME;
bool kit_plugin_player_is_silent(const KitPluginPlayer *player) REALTIME;
/** Brings everything to rest at once, and forgets what controllers have moved. Knobs stay. */
void kit_plugin_player_rest(KitPluginPlayer *player) REALTIME;

#endif
