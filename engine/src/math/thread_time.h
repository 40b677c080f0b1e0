/* SPDX-License-Identifier: MIT */
/* Processor time of the calling thread, for the limit of a build. Set-up only. */
#ifndef TB_THREAD_TIME_H
#define TB_THREAD_TIME_H

/* [s] since some moment. If the system tells no thread's time (Windows, WebAssembly), it is that of
 * all threads, or the time of day. */
double tb_thread_time(void);

#endif
