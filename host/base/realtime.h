/* SPDX-License-Identifier: MIT */
/**
 * @file realtime.h
 * An attribute for functions that the audio thread calls: no allocation, no lock, no system call,
 * bounded work. Compilers that support it can check it (clang's -Wfunction-effects and
 * -fsanitize=realtime).
 */
#ifndef TABOR_HOST_REALTIME_H
#define TABOR_HOST_REALTIME_H

#ifdef __has_attribute
#  if __has_attribute(nonblocking)
#    define REALTIME __attribute__((nonblocking))
#  endif
#endif
#ifndef REALTIME
#  define REALTIME
#endif

#endif
