/* SPDX-License-Identifier: MIT */
/**
 * @file uris.h
 * URIs of the plugins and of the properties in their states. They never change, because sessions
 * refer to them.
 */
#ifndef TABOR_LV2_URIS_H
#define TABOR_LV2_URIS_H

#define URI_DRUM "urn:tabor:drum"             /**< the plugin with a stereo output */
#define URI_DRUM_MULTI "urn:tabor:drum-multi" /**< the plugin with an output per microphone */
#define URI_EFFECT "urn:tabor:effect"         /**< the drum before a loudspeaker */
#define URI_KIT "urn:tabor:kit"               /**< the plugin that plays drum kits */

#define URI_WINDOW "urn:tabor:drum:window" /**< of the first three */
#define URI_KIT_WINDOW "urn:tabor:kit:window"

#define URI_PRESET "urn:tabor:preset:"       /**< a factory preset, with its name */
#define URI_GROUP "urn:tabor:group:"         /**< a group of ports, with its symbol */
#define URI_KIT_GROUP "urn:tabor:group:kit:" /**< the same of Tabor Kit */

#define URI_STATE_VERSION "urn:tabor:state:version" /**< atom:Int, STATE_VERSION */
/** atom:String, see definition_text.h */
#define URI_STATE_DEFINITION "urn:tabor:state:definition"
#define URI_STATE_CONTROL "urn:tabor:state:" /**< atom:Float, with a control's symbol */

#define URI_DRUM_FILE                                                                              \
  "urn:tabor:drum:file"                   /**< what a host sets: atom:Path of a preset file, and */
#define URI_KIT_FILE "urn:tabor:kit:file" /**< of a kit file */
#define URI_STATE_KIT "urn:tabor:state:kit-file" /**< atom:String, the text of a kit file */

#define STATE_VERSION 1 /**< raised when older plugins cannot read newer states */

#endif
