/* SPDX-License-Identifier: MIT */
#include <ctype.h>
#include <errno.h>
#include <poll.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include "platform/terminal.h"

#define CHUNK 512         /* bytes that a terminal with room takes without waiting */
#define LOST_PATIENCE 100 /* of a terminal that takes nothing [ms] */

/* The other screen, so that what stood on the first comes back; no cursor; and back. */
static const char screen_on[] = "\033[?1049h\033[?25l\033[2J";
static const char screen_off[] = "\033[0m\033[?25h\033[?1049l";

/* Globals: handlers have no other way to know. */
static struct termios settings_before; /* written before is_ours is first set */
static bool wants_screen;              /* likewise */
static bool is_entered;                /* between enter and leave; the using thread's */
static atomic_bool is_ours;            /* the terminal has our settings, as far as we know */
static atomic_bool is_doubtful;        /* the process was stopped: it may have others by now */
static atomic_bool has_changed;

/* ---- abilities ---- */

static bool is_set(const char *name) {
  const char *const value = getenv(name);
  return value && *value;
}

/* In a pipeline or with '&' the terminal belongs to another process group. */
static bool in_foreground(void) { return tcgetpgrp(STDIN_FILENO) == getpgrp(); }

/* The program itself stays in the "C" locale: numbers have points. */
static bool locale_is_utf8(void) {
  static const char *const names[] = {"LC_ALL", "LC_CTYPE", "LANG"};
  for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
    const char *const value = getenv(names[i]);
    if (!value || !*value) continue;
    const char *const dot = strchr(value, '.');
    return dot && (strncasecmp(dot, ".utf-8", 6) == 0 || strncasecmp(dot, ".utf8", 5) == 0);
  }
  return false;
}

static bool moves_cursor(void) {
  const char *const type = getenv("TERM");
  return type && *type && strcmp(type, "dumb") != 0;
}

TerminalAbilities terminal_abilities(void) {
  const bool keys = isatty(STDIN_FILENO) && in_foreground();
  return (TerminalAbilities){
    .keys = keys,
    .screen = keys && isatty(STDOUT_FILENO) && moves_cursor(),
    .colour = !is_set("NO_COLOR"),
    .utf8 = locale_is_utf8(),
  };
}

/* ---- taking and giving back; giving back is async-signal-safe ---- */

static void write_all(const char *bytes, size_t size) {
  while (size > 0) {
    const ssize_t count = write(STDOUT_FILENO, bytes, size);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return;
    bytes += count;
    size -= (size_t)count;
  }
}

/* Signals stay on: Ctrl-C works however busy the program is. */
static struct termios single_keys(struct termios settings) {
  settings.c_lflag &= ~(tcflag_t)(ICANON | ECHO | IEXTEN);
  settings.c_iflag &= ~(tcflag_t)(IXON | ICRNL | INLCR | IGNCR | ISTRIP);
  settings.c_cc[VMIN] = 1;
  settings.c_cc[VTIME] = 0;
  return settings;
}

static bool take(void) {
  const struct termios settings = single_keys(settings_before);
  atomic_store(&is_ours, true); /* before: a signal in between finds something to give back */
  if (tcsetattr(STDIN_FILENO, TCSADRAIN, &settings) != 0) {
    atomic_store(&is_ours, false);
    return false;
  }
  if (wants_screen) write_all(screen_on, sizeof screen_on - 1);
  atomic_store(&has_changed, true);
  return true;
}

/* Not waiting for output to drain: nobody may be reading it. Keys not read yet are forgotten, so
   that the end of a roll is not typed into the shell. In the background the terminal is another's.
 */
void terminal_restore(void) {
  if (!atomic_exchange(&is_ours, false) || !in_foreground()) return;
  if (wants_screen) write_all(screen_off, sizeof screen_off - 1);
  (void)tcflush(STDIN_FILENO, TCIFLUSH);
  (void)tcsetattr(STDIN_FILENO, TCSANOW, &settings_before);
}

/* ---- signals ---- */

/* A signal whose handler is taken while the terminal is entered. */
typedef struct Handled {
  int number;
  void (*handler)(int number, siginfo_t *info, void *context);
  struct sigaction before;
} Handled;

static void on_suspend(int number, siginfo_t *info, void *context);
static void on_change(int number, siginfo_t *info, void *context);
static void on_crash(int number, siginfo_t *info, void *context);

static Handled handled[] = {
  {.number = SIGTSTP, .handler = on_suspend}, {.number = SIGCONT, .handler = on_change},
  {.number = SIGWINCH, .handler = on_change}, {.number = SIGABRT, .handler = on_crash},
  {.number = SIGSEGV, .handler = on_crash},   {.number = SIGBUS, .handler = on_crash},
  {.number = SIGFPE, .handler = on_crash},    {.number = SIGILL, .handler = on_crash},
};
#define HANDLED (sizeof handled / sizeof handled[0])

static Handled *find_handled(int number) {
  for (size_t i = 0; i < HANDLED; i++) {
    if (handled[i].number == number) return &handled[i];
  }
  return NULL;
}

/* As the signal would be without us, which is a stop; terminal_read() takes the terminal again. */
static void on_suspend(int number, siginfo_t *info, void *context) {
  (void)info;
  (void)context;
  const int error = errno;
  struct sigaction ours, by_default = {.sa_handler = SIG_DFL};
  sigset_t set, before;
  terminal_restore();
  sigemptyset(&set);
  sigaddset(&set, number);
  (void)sigaction(number, &by_default, &ours);
  (void)raise(number);
  (void)pthread_sigmask(SIG_UNBLOCK, &set, &before); /* stops here */
  (void)pthread_sigmask(SIG_SETMASK, &before, NULL);
  (void)sigaction(number, &ours, NULL);
  errno = error;
}

/* After SIGSTOP, which nobody sees coming, the shell may have left other settings. */
static void on_change(int number, siginfo_t *info, void *context) {
  (void)info;
  (void)context;
  if (number == SIGCONT) atomic_store(&is_doubtful, true);
  atomic_store(&has_changed, true);
}

/* Then as without us: a fault happens again when its instruction is repeated, others are sent
 * again. */
static void on_crash(int number, siginfo_t *info, void *context) {
  (void)context;
  terminal_restore();
  (void)sigaction(number, &find_handled(number)->before, NULL);
  const bool is_fault = info->si_code > 0;
  if (!is_fault) (void)raise(number);
}

static void handle_signals(void) {
  for (size_t i = 0; i < HANDLED; i++) {
    struct sigaction action = {.sa_sigaction = handled[i].handler, .sa_flags = SA_SIGINFO};
    sigfillset(&action.sa_mask);
    (void)sigaction(handled[i].number, &action, &handled[i].before);
    const bool was_ignored = handled[i].before.sa_handler == SIG_IGN;
    if (was_ignored && handled[i].number == SIGTSTP) {
      (void)sigaction(SIGTSTP, &handled[i].before, NULL); /* a shell without job control */
    }
  }
}

static void unhandle_signals(void) {
  for (size_t i = 0; i < HANDLED; i++) {
    (void)sigaction(handled[i].number, &handled[i].before, NULL);
  }
}

/* ---- use ---- */

bool terminal_enter(bool screen) {
  static bool is_registered;
  if (is_entered) return true;
  if (tcgetattr(STDIN_FILENO, &settings_before) != 0) return false;
  wants_screen = screen;
  if (!is_registered) is_registered = atexit(terminal_leave) == 0;
  handle_signals();
  is_entered = true;
  if (take()) return true;
  const int error = errno;
  terminal_leave();
  errno = error;
  return false;
}

void terminal_leave(void) {
  if (!is_entered) return;
  terminal_restore();
  unhandle_signals();
  is_entered = false;
}

static bool is_usable(void) { return atomic_load(&is_ours) && !atomic_load(&is_doubtful); }

/* Takes the terminal again after a suspension. */
static bool is_back(void) {
  if (!is_entered || is_usable()) return is_entered;
  if (!in_foreground()) return false;
  atomic_store(&is_doubtful, false);
  return take();
}

ptrdiff_t terminal_read(unsigned char *bytes, size_t size, int timeout) {
  struct pollfd input = {.fd = STDIN_FILENO, .events = POLLIN};
  const bool waits_only = !is_back();
  const int ready = poll(&input, waits_only ? 0 : 1, timeout);
  if (ready <= 0 || !is_back()) return 0;
  const ssize_t count = read(STDIN_FILENO, bytes, size);
  if (count < 0 && (errno == EINTR || errno == EAGAIN)) return 0;
  return count > 0 ? count : -1;
}

static bool has_room(void) {
  struct pollfd output = {.fd = STDOUT_FILENO, .events = POLLOUT};
  return poll(&output, 1, LOST_PATIENCE) == 1 && output.revents == POLLOUT;
}

bool terminal_write(const char *bytes, size_t size) {
  while (size > 0) {
    if (!is_usable() || !has_room()) return false;
    const ssize_t count = write(STDOUT_FILENO, bytes, size < CHUNK ? size : CHUNK);
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) {
      bytes += count;
      size -= (size_t)count;
    }
  }
  return true;
}

TerminalSize terminal_size(void) {
  struct winsize window = {0};
  (void)ioctl(STDOUT_FILENO, TIOCGWINSZ, &window);
  if (window.ws_col == 0 || window.ws_row == 0) return (TerminalSize){80, 24};
  return (TerminalSize){window.ws_col, window.ws_row};
}

bool terminal_changed(void) { return atomic_exchange(&has_changed, false); }
