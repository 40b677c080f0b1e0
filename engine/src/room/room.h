/* SPDX-License-Identifier: MIT */
/* A shoebox room of volume V and surface S around a drum.
 *
 * Decay. Sound at f falls by 60 dB in T(f), 1/T(f) = 1/T0 + (1/T8 - 1/T0) s(f)/s(8 kHz) with s(f) =
 * sin^2(pi f k), k the time step: below 8 kHz the loss on top of that at low notes rises about with
 * f^2, as that of the air does. By Sabine's law A(f) = 24 ln(10) V/(c T(f)) is the area of an open
 * window that would absorb as much, and by Eyring's a wall keeps the part 1 - alpha = exp(-A/S) of
 * the energy.
 *
 * First reflections. Each of the six walls shows an image of the drum: at the distance d the
 * microphone hears sqrt(1 - alpha)/d of what it would hear at 1 m, after (d - r)/c where the feed
 * heard it from the distance r, in whole samples. An image takes the feed that lies nearest to the
 * direction in which its ray leaves.
 *
 * Late sound. A drum heard with the energy 1 at 1 m fills a diffuse field with 16 pi/A, which
 * decays with T from the moment of the stroke. Its rest after the mean free path 4 V/S,
 * (16 pi/A) exp(-A/S), is the late sound's; what came before is the first reflections'. Thirty-two
 * delay lines of prime lengths, in geometric order over 0.55 to 1.8 mean free paths, feed each
 * other through a Hadamard matrix H,
 *
 *   x_i(n) = y_i(n - M_i), s_i = filter_i(x_i), y = H s/sqrt(32) + u_1 f_1 + u_2 f_2,
 *   filter_i(z) = g (1 - b)/(1 - b/z), with g = 10^(-3 M_i k/T0) and the same law for T8 at 8 kHz.
 *
 * H/sqrt(32) is orthogonal and |filter| < 1, so energy can only fall, and all modes of the network
 * decay with T(f). A pass leaves the part G of the energy in all lines, the mean of g^2: a feed of
 * energy 1 gives G/(1 - G), by which the late sound is normalised. Feeds and microphones have
 * orthogonal rows of signs, so that microphones hear different sound. If T0 is long for the size,
 * lines are longer, so that the network's modes lie dense enough to overlap: 0.45 T0 of them a
 * hertz.
 *
 * Microphones. The room hears the sound pressure: what a feed's frequency response does is undone
 * first, by the inverse of that filter, which is stable (model/mic_response.h). Sound that the room
 * sends to a microphone passes the response of that microphone, as does what the drum sends there.
 *
 * Limits: the drum stands upright, its centre at 0.43 of the length, 0.37 of the width and 0.7 m
 * above the floor; microphones beyond a wall stand before it, and those inside the drum hear no
 * room. Far below the frequency at which a room's own modes overlap, a real room has single ones;
 * this one has not. With one pole a line, T is right within 5 % up to 8 kHz for T8 >= T0/2, and up
 * to 15 % too long at 16 kHz. */
#ifndef TB_ROOM_H
#define TB_ROOM_H

#include "model/mic_response.h"
#include "tabor/tabor.h"

#define TB_ROOM_LINES 32
#define TB_ROOM_FEEDS 2
#define TB_ROOM_IMAGES 6
#define TB_ROOM_PIECE 32 /* frames computed at once at most */

/* One image of the drum at one microphone. */
typedef struct TbRoomImage {
  uint32_t delay, feed; /* delay in frames */
  float gain;
} TbRoomImage;

typedef struct TbRoomMic {
  float late[TB_ROOM_LINES];
  TbRoomImage image[TB_ROOM_IMAGES];
  TbMicResponse response;
} TbRoomMic;

/* All that changes, in one piece of memory. `memory` holds the rings of the lines, then those of
 * the reflected feeds. A ring's oldest value stands at its position. */
typedef struct TbRoomState {
  uint64_t fingerprint;
  uint32_t position[TB_ROOM_LINES];
  uint32_t early_position;
  uint32_t quiet; /* frames since anything but zero was written to a ring, while awake */
  uint32_t asleep;
  float power; /* of the values written, smoothed */
  float filter[TB_ROOM_LINES];
  float reflected[TB_ROOM_FEEDS];
  TbResponseMemory undone[TB_ROOM_FEEDS], response[TABOR_MAX_MICS]; /* of the filters */
  float memory[];
} TbRoomState;

struct TaborRoom {
  TaborAllocator allocator;
  TaborRoomInfo info;
  uint64_t fingerprint;
  uint32_t mic_count;
  uint32_t length[TB_ROOM_LINES],
    start[TB_ROOM_LINES]; /* of each ring, and where it starts in memory */
  uint32_t piece;         /* frames at once: no longer than a line */
  uint32_t early_length, early_start[TB_ROOM_FEEDS]; /* a power of two */
  uint32_t longest; /* frames after which all read values are new */
  uint32_t memory_count;
  float gain[TB_ROOM_LINES], pole[TB_ROOM_LINES]; /* s = pole s + gain x */
  float feed_gain[TB_ROOM_FEEDS];
  TbMicResponse undo[TB_ROOM_FEEDS]; /* inverse of each feed's response */
  float inject[TB_ROOM_FEEDS][TB_ROOM_LINES];
  float wall_gain, wall_pole;
  double power_gain; /* from state->power to tabor_room_energy() */
  float power_rate;
  TbRoomMic mic[TABOR_MAX_MICS];
  TbRoomState *state;
};

/* Fills in everything but allocator and state. For a room of kind none only info.kind is set. */
void tb_room_plan(TaborRoom *room, const TaborDrumDef *def, double sample_rate);
/* True if both are the same room around the same drum, so that one may go on with the other's
 * state. */
bool tb_room_is_same(const TaborRoom *a, const TaborRoom *b);
/* Bytes of the state, a multiple of 8. */
size_t tb_room_state_bytes(const TaborRoom *room);
/* Audio-safe: computes frames `from` to `from` + `frames`; frames <= room->piece. */
void tb_room_step(TaborRoom *room, const float *const *dry, float *const *outputs, uint32_t from,
                  uint32_t frames);

#endif
