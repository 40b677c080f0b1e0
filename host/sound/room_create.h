/* SPDX-License-Identifier: MIT */
/**
 * @file room_create.h
 * Creates the room of a drum's definition for a program, which prints what is wrong.
 */
#ifndef TABOR_HOST_ROOM_CREATE_H
#define TABOR_HOST_ROOM_CREATE_H

#include "base/message.h"
#include "sound/room_mix.h"

/** Puts the room of @p def behind outputs that are its microphones in their order. Free with
 * room_mix_free(), whatever the outcome. */
Outcome room_create(const TaborDrumDef *def, double rate, RoomMix *room);

#endif
