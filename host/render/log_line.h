/* SPDX-License-Identifier: MIT */
/**
 * @file log_line.h
 * The lines of a log: what was played, as text from which it can be played again to the bit.
 *
 * Each line is a JSON object; numbers have 17 digits.
 *
 *     {"tabor_log":1,"program":"0.2.0","rate":48000.0,"gain":1.0,"mics":["top"],...}
 *     {"frame":4800,"event":"strike","velocity":2.5,"radius":0.05}
 *     {"frame":5000,"event":"parameter","parameter":"wires.strainer","value":0.5}
 *     {"frame":6000,"gain":0.5}
 *     {"model":1,"preset":"tabor","quality":"live","drum":["shell.radius = 0.1651",...]}
 *     {"frame":9600,"swap":1}
 *     {"frames":48000,"lost":0}
 *
 * Of a kit, the first line has "kit", the text of its file with all parameters of each drum, in
 * place of "mics" and "drum"; events and swaps have "drum", the number of the drum from 0 (left
 * out: 0) or "all", or "note", that of a sample.
 *
 * The first line has the drum of the start, the last the number of frames that were played. While
 * the drum plays, the last line is a mark, {"played":24000,"lost":0}: everything that acted before
 * this frame is in the lines above. The next lines are written over it, so a whole log has none.
 * Messages are in the order in which they acted, each with the frame at which it did. A field that
 * is left out is 0; radius and angle are in m and degrees. A model's line comes before the swap or
 * the replacement that it is for.
 */
#ifndef TABOR_HOST_LOG_LINE_H
#define TABOR_HOST_LOG_LINE_H

#include "base/message.h"
#include "kit/kit_sample_files.h"
#include "sound/player_message.h"

#define LOG_VERSION 1

typedef enum LogLineType { LOG_START, LOG_MODEL, LOG_MESSAGE, LOG_MARK, LOG_END } LogLineType;

/** A drum and what its model was built with. */
typedef struct LogDrum {
  char preset[TABOR_TEXT_SIZE]; /**< a name or a file, for display */
  uint32_t quality;             /**< a TaborQuality, never the default */
  TaborDrumDef def;
} LogDrum;

/** How a performance started, apart from its drum. */
typedef struct LogStart {
  char program[TABOR_NAME_SIZE]; /**< version */
  double rate;                   /**< [Hz] */
  double gain;                   /**< factor */
  const TaborKitDef *kit;        /**< to be written; or NULL */
  uint32_t channels;
  uint32_t mics[TABOR_MAX_MICS]; /**< of each channel: index among the drum's microphones, of a kit
                                    its output */
} LogStart;

/** A line that was read. */
typedef struct LogLine {
  LogLineType type;
  LogStart start;   /**< of LOG_START */
  LogDrum *drum;    /**< of LOG_START and LOG_MODEL, of a kit's start without definition; the caller
                       frees it */
  TaborKitDef *kit; /**< of a kit's LOG_START; the caller frees it */
  uint32_t model;   /**< its number, of LOG_MODEL; those of a log are 1, 2, ... */
  PlayerMessage message; /**< of LOG_MESSAGE; a swap itself and its strikers are not in the text */
  uint64_t frames, lost; /**< of LOG_MARK and LOG_END: frames played, messages lost */
} LogLine;

/** Each returns a line with its line feed, which the caller frees; NULL if memory is short. */
char *log_line_start(const LogStart *start, const TaborModel *model, const char *preset);
char *log_line_model(uint32_t number, const TaborModel *model, const char *preset);
char *log_line_message(const PlayerMessage *message);
char *log_line_mark(uint64_t frames, uint64_t lost);
char *log_line_end(uint64_t frames, uint64_t lost);

/** True if the text is no whole JSON value, as the last line of a log whose writer was killed. */
bool log_line_is_cut(const char *text, size_t length);

/**
 * Reads a line of @p length bytes. Refuses what no log has, in a message that begins with @p where,
 * such as "take.log:3:". line->drum and line->kit are NULL or to be freed, whatever the outcome.
 */
Outcome log_line_read(const char *where, const char *text, size_t length, LogLine *line);

#endif
