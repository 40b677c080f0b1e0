/* SPDX-License-Identifier: MIT */
/* On a pseudo-terminal: its settings after every way of leaving are those before. */
#include "platform/terminal.h"

#include <errno.h>
#include <poll.h>
#include <pty.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>
#include <utmp.h>

#include <cmocka.h>

#include "base/interrupt.h"

#define PATIENCE 10000 /* for what happens at once on an idle machine [ms] */

/* A process on a terminal of its own, seen from outside. */
typedef struct Stage {
  int outside; /* end of the terminal that a screen and a keyboard would have */
  pid_t process;
  struct termios before;
  char shown[65536]; /* since the beginning */
  size_t length;
} Stage;

/* What the process does once it is on the terminal: its exit status. */
typedef int Scene(void);

static struct termios settings(const Stage *stage) {
  struct termios now;
  assert_int_equal(tcgetattr(stage->outside, &now), 0);
  return now;
}

static bool same_settings(const struct termios *a, const struct termios *b) {
  return a->c_iflag == b->c_iflag && a->c_oflag == b->c_oflag && a->c_cflag == b->c_cflag &&
         a->c_lflag == b->c_lflag && memcmp(a->c_cc, b->c_cc, sizeof a->c_cc) == 0;
}

static void begin(Stage *stage, Scene *scene) {
  const struct winsize size = {.ws_row = 30, .ws_col = 100};
  memset(stage, 0, sizeof *stage);
  int inside;
  assert_int_equal(openpty(&stage->outside, &inside, NULL, NULL, &size), 0);
  stage->before = settings(stage);
  stage->process = fork();
  assert_true(stage->process >= 0);
  if (stage->process == 0) {
    (void)close(stage->outside);
    if (login_tty(inside) != 0) _exit(99);
    _exit(scene());
  }
  (void)close(inside);
}

/* Takes in what is shown for up to @p timeout ms; false if nothing comes. */
static bool look(Stage *stage, int timeout) {
  struct pollfd output = {.fd = stage->outside, .events = POLLIN};
  const size_t room = sizeof stage->shown - 1 - stage->length;
  if (room == 0 || poll(&output, 1, timeout) <= 0) return false;
  const ssize_t count = read(stage->outside, stage->shown + stage->length, room);
  if (count <= 0) return false; /* EIO: the other end is closed */
  stage->length += (size_t)count;
  return true;
}

static void await(Stage *stage, const char *text) {
  while (!strstr(stage->shown, text)) {
    if (!look(stage, PATIENCE)) fail_msg("'%s' was not shown, but: %s", text, stage->shown);
  }
}

static void forget(Stage *stage) {
  stage->length = 0;
  memset(stage->shown, 0, sizeof stage->shown);
}

static void type(const Stage *stage, const char *keys) {
  assert_int_equal(write(stage->outside, keys, strlen(keys)), strlen(keys));
}

/* The process has ended: how, as the shell tells it. */
static int end(Stage *stage) {
  int status = 0;
  while (look(stage, 50) || waitpid(stage->process, &status, WNOHANG) == 0) {}
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

static void assert_restored(Stage *stage) {
  const struct termios after = settings(stage);
  assert_true(same_settings(&after, &stage->before));
  assert_non_null(strstr(stage->shown, "\033[?1049h"));
  assert_non_null(strstr(stage->shown, "\033[?1049l"));
  assert_non_null(strstr(stage->shown, "\033[?25h"));
  (void)close(stage->outside);
}

/* ---- scenes; they run in the process on the terminal ---- */

static void say(const char *text) { (void)!write(STDOUT_FILENO, text, strlen(text)); }

static void enter(void) {
  interrupt_install();
  interrupt_at_end(terminal_restore);
  if (!terminal_enter(true)) exit(98);
  say("entered");
}

/* Shows keys until a 'q'. */
static void show_keys(void) {
  unsigned char keys[64];
  ptrdiff_t count = 0;
  while ((count = terminal_read(keys, sizeof keys, 20)) >= 0) {
    if (terminal_changed()) {
      char text[64];
      const TerminalSize size = terminal_size();
      (void)snprintf(text, sizeof text, "<%dx%d>", size.columns, size.rows);
      (void)terminal_write(text, strlen(text));
    }
    for (ptrdiff_t i = 0; i < count; i++) {
      if (keys[i] == 'q') return;
      char text[8];
      (void)snprintf(text, sizeof text, "[%02x]", keys[i]);
      (void)terminal_write(text, strlen(text));
    }
  }
  exit(97);
}

static int leave_normally(void) {
  enter();
  show_keys();
  terminal_leave();
  terminal_leave();
  return 0;
}

static int leave_by_exit(void) {
  enter();
  show_keys();
  exit(1);
}

/* As a failed assertion does. */
static int leave_by_abort(void) {
  enter();
  show_keys();
  abort();
}

/* Sanitizers would end the process before the processor does. */
__attribute__((no_sanitize("undefined", "address"))) static int leave_by_fault(void) {
  enter();
  show_keys();
  volatile int *volatile nowhere = NULL;
  *nowhere = 1;
  return 0;
}

/* ---- cases ---- */

static void single_keys_come_unechoed(void **state) {
  (void)state;
  Stage stage;
  begin(&stage, leave_normally);
  await(&stage, "<100x30>");
  struct termios during = settings(&stage);
  assert_false(same_settings(&during, &stage.before));
  assert_int_equal(during.c_lflag & (tcflag_t)(ICANON | ECHO), 0);
  forget(&stage);
  type(&stage, "k\r\x13\x1b\xc3\xa9"); /* also Ctrl-S, which would have stopped the output */
  await(&stage, "[6b][0d][13][1b][c3][a9]");
  assert_null(strchr(stage.shown, 'k'));
  type(&stage, "q");
  (void)snprintf(stage.shown, sizeof stage.shown, "\033[?1049h");
  stage.length = strlen(stage.shown);
  assert_int_equal(end(&stage), 0);
  assert_restored(&stage);
}

static void exit_restores(void **state) {
  (void)state;
  Stage stage;
  begin(&stage, leave_by_exit);
  await(&stage, "entered");
  type(&stage, "q");
  assert_int_equal(end(&stage), 1);
  assert_restored(&stage);
}

static void failed_assertions_restore(void **state) {
  (void)state;
  Stage stage;
  begin(&stage, leave_by_abort);
  await(&stage, "entered");
  type(&stage, "q");
  assert_int_equal(end(&stage), 128 + SIGABRT);
  assert_restored(&stage);
}

static void faults_restore(void **state) {
  (void)state;
  Stage stage;
  begin(&stage, leave_by_fault);
  await(&stage, "entered");
  type(&stage, "q");
  assert_int_not_equal(end(&stage), 0); /* 139, or as a sanitizer ends it */
  assert_restored(&stage);
}

static void fatal_signals_restore(void **state) {
  (void)state;
  const int signals[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGABRT};
  for (size_t i = 0; i < sizeof signals / sizeof signals[0]; i++) {
    Stage stage;
    begin(&stage, leave_normally);
    await(&stage, "<100x30>");
    assert_int_equal(kill(stage.process, signals[i]), 0);
    assert_int_equal(end(&stage), 128 + signals[i]);
    assert_restored(&stage);
  }
}

static void control_keys_are_signals(void **state) {
  (void)state;
  Stage stage;
  begin(&stage, leave_normally);
  await(&stage, "<100x30>");
  type(&stage, "\x03");
  assert_int_equal(end(&stage), 128 + SIGINT);
  assert_restored(&stage);
}

/* A session leader's group is orphaned, and such are not stopped by the terminal: there has to be a
 * shell. */
static Scene *scene_of_job;
static int run_as_job(void) {
  (void)signal(SIGTTOU, SIG_IGN);
  const pid_t job = fork();
  if (job == 0) {
    (void)setpgid(0, 0);
    (void)tcsetpgrp(STDIN_FILENO, getpid());
    (void)signal(SIGTTOU, SIG_DFL);
    _exit(scene_of_job());
  }
  (void)setpgid(job, job);
  struct termios mine;
  (void)tcgetattr(STDIN_FILENO, &mine);
  for (int status = 0;;) {
    if (waitpid(job, &status, WUNTRACED) < 0) return 96;
    if (!WIFSTOPPED(status))
      return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
    (void)tcsetpgrp(STDIN_FILENO, getpgrp());
    say(WSTOPSIG(status) == SIGTSTP ? "suspended" : "stopped");
    char word;
    (void)!read(STDIN_FILENO, &word, 1); /* a line: the settings must be those before */
    if (WSTOPSIG(status) == SIGSTOP) (void)tcsetattr(STDIN_FILENO, TCSANOW, &mine);
    (void)tcsetpgrp(STDIN_FILENO, job);
    (void)kill(-job, SIGCONT);
  }
}

static void suspension_restores_and_resumes(void **state) {
  (void)state;
  Stage stage;
  scene_of_job = leave_normally;
  begin(&stage, run_as_job);
  for (int times = 0; times < 2; times++) {
    await(&stage, "<100x30>");
    forget(&stage);
    type(&stage, "\x1a");
    await(&stage, "suspended");
    const struct termios meanwhile = settings(&stage);
    assert_true(same_settings(&meanwhile, &stage.before));
    assert_non_null(strstr(stage.shown, "\033[?1049l"));
    forget(&stage);
    type(&stage, "\n");
    await(&stage, "\033[?1049h");
  }
  await(&stage, "<100x30>");
  type(&stage, "q");
  assert_int_equal(end(&stage), 0);
  assert_restored(&stage);
}

static void size_changes_are_told(void **state) {
  (void)state;
  Stage stage;
  begin(&stage, leave_normally);
  await(&stage, "<100x30>");
  const struct winsize size = {.ws_row = 5, .ws_col = 20};
  assert_int_equal(ioctl(stage.outside, TIOCSWINSZ, &size), 0);
  await(&stage, "<20x5>");
  type(&stage, "q");
  assert_int_equal(end(&stage), 0);
  assert_restored(&stage);
}

static void a_terminal_that_is_gone_ends_reading(void **state) {
  (void)state;
  Stage stage;
  begin(&stage, leave_normally);
  await(&stage, "<100x30>");
  (void)close(stage.outside);
  int status = 0;
  assert_int_equal(waitpid(stage.process, &status, 0), stage.process);
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  assert_true(code == 97 || code == 128 + SIGHUP); /* the hang-up comes as a signal, too */
}

static int tell_abilities(void) {
  const TerminalAbilities can = terminal_abilities();
  char text[64];
  (void)snprintf(text, sizeof text, "keys %d screen %d colour %d utf8 %d.", can.keys, can.screen,
                 can.colour, can.utf8);
  say(text);
  return 0;
}

static void set(const char *name, const char *value) {
  if (value) {
    (void)setenv(name, value, 1);
  } else {
    (void)unsetenv(name);
  }
}

static void expect_abilities(const char *type, const char *no_color, const char *locale,
                             const char *expected) {
  Stage stage;
  set("TERM", type);
  set("NO_COLOR", no_color);
  set("LC_ALL", locale);
  begin(&stage, tell_abilities);
  await(&stage, expected);
  assert_int_equal(end(&stage), 0);
  (void)close(stage.outside);
}

static void abilities_follow_the_environment(void **state) {
  (void)state;
  expect_abilities("xterm", NULL, "C", "keys 1 screen 1 colour 1 utf8 0.");
  expect_abilities("dumb", "", "de_DE.UTF-8", "keys 1 screen 0 colour 1 utf8 1.");
  expect_abilities(NULL, "1", "C.utf8", "keys 1 screen 0 colour 0 utf8 1.");
}

static int tell_without_keys(void) {
  (void)!freopen("/dev/null", "r", stdin);
  return tell_abilities();
}

static int tell_without_screen(void) {
  (void)dup2(STDOUT_FILENO, STDERR_FILENO);
  (void)!freopen("/dev/null", "w", stdout);
  const TerminalAbilities can = terminal_abilities();
  const char *const text = can.keys && !can.screen ? "no screen." : "wrong.";
  (void)!write(STDERR_FILENO, text, strlen(text));
  return 0;
}

static void streams_that_are_no_terminals_are_seen(void **state) {
  (void)state;
  Stage stage;
  set("TERM", "xterm");
  begin(&stage, tell_without_keys);
  await(&stage, "keys 0 screen 0");
  assert_int_equal(end(&stage), 0);
  (void)close(stage.outside);
  begin(&stage, tell_without_screen);
  await(&stage, "no screen.");
  assert_int_equal(end(&stage), 0);
  (void)close(stage.outside);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(single_keys_come_unechoed),
    cmocka_unit_test(exit_restores),
    cmocka_unit_test(failed_assertions_restore),
    cmocka_unit_test(faults_restore),
    cmocka_unit_test(fatal_signals_restore),
    cmocka_unit_test(control_keys_are_signals),
    cmocka_unit_test(suspension_restores_and_resumes),
    cmocka_unit_test(size_changes_are_told),
    cmocka_unit_test(a_terminal_that_is_gone_ends_reading),
    cmocka_unit_test(abilities_follow_the_environment),
    cmocka_unit_test(streams_that_are_no_terminals_are_seen),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
