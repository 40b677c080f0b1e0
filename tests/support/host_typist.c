/* SPDX-License-Identifier: MIT */
/**
 * @file host_typist.c
 * Simulates a user at a terminal: runs a program on a pseudo-terminal, types from a script, and
 * reads the screen.
 *
 *     host_typist SCRIPT PROGRAM ARGUMENT...
 *
 * Commands of the script, one per line, executed in order:
 *     wait TEXT      waits until the screen shows it; gives up with status 1 after a minute
 *     gone TEXT      waits until the screen no longer shows it
 *     read FILE TEXT waits until a line of the file has the text; gives up likewise
 *     type TEXT      \e is Escape, \r Enter, \t Tab, \xHH any byte; prints "typed SECONDS" of a
 *                    monotonic clock
 *     sleep SECONDS
 *     escape         types Escape twice within a tenth of a second, which quits the program;
 *                    retries if a busy machine took longer
 *     signal NUMBER  sends it to the program
 *     size COLUMNS ROWS   sets the size of the terminal
 *     raw, cooked    waits until the terminal delivers single keys, or lines; gives up likewise
 *     show           prints the screen
 * After the script the program has a minute to end. host_typist then prints "status N", as a shell
 * reports it; "settings same" or "settings changed" for the terminal's settings compared with those
 * before the start; and "screen main" if the terminal is back on the main screen with a visible
 * cursor.
 */
#define _GNU_SOURCE
#include <poll.h>
#include <pty.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>
#include <utmp.h>

#define PATIENCE 60.0 /* [s] */
#define ESCAPES 5     /* pairs of them that are typed at most */
#define MOST_COLUMNS 400
#define MOST_ROWS 120

static int terminal = -1; /* its outer end */
static pid_t program;
static struct termios before;

/* ---- the screen: what tabor's sequences do to it ---- */

static struct {
  char cells[MOST_ROWS][MOST_COLUMNS][5]; /* UTF-8 */
  int row, column, rows, columns;
  char sequence[32], character[5];
  size_t sequence_length, character_length, character_size;
  bool is_other, has_cursor;
} screen = {.rows = 24, .columns = 80, .has_cursor = true};

static void clear_screen(void) {
  for (int row = 0; row < MOST_ROWS; row++) {
    for (int column = 0; column < MOST_COLUMNS; column++) strcpy(screen.cells[row][column], " ");
  }
}

static void scroll(void) {
  memmove(screen.cells[0], screen.cells[1], sizeof screen.cells - sizeof screen.cells[0]);
  for (int column = 0; column < MOST_COLUMNS; column++)
    strcpy(screen.cells[screen.rows - 1][column], " ");
}

static void new_line(void) {
  if (++screen.row < screen.rows) return;
  screen.row = screen.rows - 1;
  scroll();
}

static void put_character(void) {
  if (screen.column >= screen.columns) {
    screen.column = 0;
    new_line();
  }
  strcpy(screen.cells[screen.row][screen.column++], screen.character);
}

static void obey(const char *sequence) {
  const char end = sequence[strlen(sequence) - 1];
  if (strcmp(sequence, "[?1049h") == 0) screen.is_other = true;
  if (strcmp(sequence, "[?1049l") == 0) screen.is_other = false;
  if (strstr(sequence, "?1049")) { /* what stood on the main one is not asked for here */
    clear_screen();
    screen.row = screen.column = 0;
  }
  if (strcmp(sequence, "[?25l") == 0) screen.has_cursor = false;
  if (strcmp(sequence, "[?25h") == 0) screen.has_cursor = true;
  if (end == 'J') clear_screen();
  if (end == 'H' && sscanf(sequence, "[%d;%d", &screen.row, &screen.column) == 2) {
    screen.row = screen.row - 1 < screen.rows ? screen.row - 1 : screen.rows - 1;
    screen.column = screen.column - 1 < screen.columns ? screen.column - 1 : screen.columns - 1;
  }
}

static void take_character_byte(unsigned char byte) {
  if (byte < 0x80 || byte >= 0xC0) {
    screen.character_length = 0;
    screen.character_size = byte < 0x80 ? 1 : byte < 0xE0 ? 2 : byte < 0xF0 ? 3 : 4;
  }
  if (screen.character_length == 4) return;
  screen.character[screen.character_length++] = (char)byte;
  screen.character[screen.character_length] = '\0';
  if (screen.character_length == screen.character_size) put_character();
}

static void take_byte(unsigned char byte) {
  if (screen.sequence_length > 0) {
    const size_t length = screen.sequence_length++;
    screen.sequence[length - 1] = (char)byte;
    screen.sequence[length] = '\0';
    const bool ends = length > 1 && byte >= 0x40 && byte <= 0x7e;
    if (ends) obey(screen.sequence);
    if (ends || length + 2 > sizeof screen.sequence) screen.sequence_length = 0;
  } else if (byte == 0x1b) {
    screen.sequence_length = 1;
  } else if (byte == '\r') {
    screen.column = 0;
  } else if (byte == '\n') {
    new_line();
  } else if (byte >= ' ') {
    take_character_byte(byte);
  }
}

static const char *row_text(int row) {
  static char text[MOST_COLUMNS * 4 + 1];
  text[0] = '\0';
  for (int column = 0; column < screen.columns; column++) strcat(text, screen.cells[row][column]);
  for (size_t end = strlen(text); end > 0 && text[end - 1] == ' '; end--) text[end - 1] = '\0';
  return text;
}

static bool is_shown(const char *text) {
  for (int row = 0; row < screen.rows; row++) {
    if (strstr(row_text(row), text)) return true;
  }
  return false;
}

static void show(FILE *file) {
  for (int row = 0; row < screen.rows; row++) (void)fprintf(file, "|%s\n", row_text(row));
}

/* ---- the typist ---- */

static double now(void) {
  struct timespec time;
  (void)clock_gettime(CLOCK_MONOTONIC, &time);
  return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static _Noreturn void give_up(const char *why, const char *text) {
  (void)fprintf(stderr, "host_typist: %s '%s'; the screen:\n", why, text);
  show(stderr);
  if (program > 0) (void)kill(program, SIGKILL);
  exit(1);
}

/* Takes in what the program shows for up to @p seconds; false once it shows nothing more. */
static bool look(double seconds) {
  struct pollfd output = {.fd = terminal, .events = POLLIN};
  unsigned char bytes[4096];
  if (poll(&output, 1, (int)(1e3 * seconds) + 1) <= 0) return true;
  const ssize_t count = read(terminal, bytes, sizeof bytes);
  for (ssize_t i = 0; i < count; i++) take_byte(bytes[i]);
  return count > 0;
}

static void look_for(double seconds) {
  const double end = now() + seconds;
  for (double left = seconds; left > 0; left = end - now()) {
    if (!look(left)) {
      const struct timespec rest = {.tv_nsec = 1000000};
      (void)nanosleep(&rest, NULL);
    }
  }
}

static void await(const char *text, bool wanted) {
  const double end = now() + PATIENCE;
  while (is_shown(text) != wanted) {
    if (now() > end) give_up(wanted ? "not shown:" : "still shown:", text);
    look_for(0.01);
  }
}

/* "FILE TEXT" */
static void await_line(const char *words) {
  char path[256] = "", line[1024];
  const double end = now() + PATIENCE;
  (void)sscanf(words, "%255s", path);
  const char *const text = words + strlen(path) + 1;
  for (bool found = false; !found; look_for(0.01)) {
    if (now() > end) give_up("not in the file:", words);
    FILE *const file = fopen(path, "r");
    while (file && !found && fgets(line, sizeof line, file)) found = strstr(line, text) != NULL;
    if (file) (void)fclose(file);
  }
}

static size_t unescape(const char *text, char *bytes) {
  size_t count = 0;
  for (; *text; text++) {
    char byte = *text;
    if (byte == '\\' && text[1]) {
      unsigned value = 0;
      byte = *++text;
      if (byte == 'e') byte = 0x1b;
      if (byte == 'r') byte = '\r';
      if (byte == 't') byte = '\t';
      if (byte == 'x' && sscanf(text + 1, "%2x", &value) == 1) {
        byte = (char)value;
        text += 2;
      }
    }
    bytes[count++] = byte;
  }
  return count;
}

static void type(const char *text) {
  char bytes[1024];
  const size_t count = unescape(text, bytes);
  printf("typed %.6f\n", now());
  if (write(terminal, bytes, count) != (ssize_t)count) give_up("cannot type", text);
}

static bool is_running(void) {
  siginfo_t info = {0};
  return waitid(P_PID, (id_t)program, &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == 0;
}

static void escape(void) {
  for (int pair = 0; pair < ESCAPES && is_running(); pair++) {
    if (pair > 0) printf("Escape once more\n");
    type("\\e");
    look_for(0.1);
    type("\\e");
    for (const double end = now() + 3; is_running() && now() < end;) look_for(0.01);
  }
}

static void set_size(const char *text) {
  struct winsize size = {0};
  if (sscanf(text, "%hu %hu", &size.ws_col, &size.ws_row) != 2) give_up("no size:", text);
  screen.columns = size.ws_col;
  screen.rows = size.ws_row;
  (void)ioctl(terminal, TIOCSWINSZ, &size);
}

static bool takes_lines(void) {
  struct termios settings;
  (void)tcgetattr(terminal, &settings);
  return (settings.c_lflag & ICANON) != 0;
}

static void await_mode(bool lines) {
  const double end = now() + PATIENCE;
  while (takes_lines() != lines) {
    if (now() > end) give_up("the terminal is not", lines ? "cooked" : "raw");
    look_for(0.01);
  }
}

static void obey_line(const char *line) {
  char word[16] = "";
  const char *const rest = line + strcspn(line, " ") + (strchr(line, ' ') ? 1 : 0);
  (void)sscanf(line, "%15s", word);
  if (strcmp(word, "wait") == 0) {
    await(rest, true);
  } else if (strcmp(word, "gone") == 0) {
    await(rest, false);
  } else if (strcmp(word, "read") == 0) {
    await_line(rest);
  } else if (strcmp(word, "type") == 0) {
    type(rest);
  } else if (strcmp(word, "escape") == 0) {
    escape();
  } else if (strcmp(word, "sleep") == 0) {
    look_for(strtod(rest, NULL));
  } else if (strcmp(word, "signal") == 0) {
    (void)kill(program, atoi(rest));
  } else if (strcmp(word, "size") == 0) {
    set_size(rest);
  } else if (strcmp(word, "raw") == 0 || strcmp(word, "cooked") == 0) {
    await_mode(word[0] == 'c');
  } else if (strcmp(word, "show") == 0) {
    show(stdout);
  } else if (*word) {
    give_up("unknown line", line);
  }
}

static void run_script(const char *path) {
  char line[1024];
  FILE *const script = fopen(path, "r");
  if (!script) give_up("cannot read", path);
  while (fgets(line, sizeof line, script)) {
    line[strcspn(line, "\n")] = '\0';
    obey_line(line);
  }
  (void)fclose(script);
}

static bool same_settings(void) {
  struct termios after;
  (void)tcgetattr(terminal, &after);
  return after.c_iflag == before.c_iflag && after.c_oflag == before.c_oflag &&
         after.c_cflag == before.c_cflag && after.c_lflag == before.c_lflag &&
         memcmp(after.c_cc, before.c_cc, sizeof after.c_cc) == 0;
}

static void report(void) {
  int status = 0;
  const double end = now() + PATIENCE;
  while (waitpid(program, &status, WNOHANG) == 0) {
    if (now() > end) give_up("still running:", "the program");
    look_for(0.01);
  }
  look_for(0.05);
  printf("status %d\n", WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status));
  printf("settings %s\n", same_settings() ? "same" : "changed");
  printf("screen %s\n", !screen.is_other && screen.has_cursor ? "main" : "other");
}

int main(int argc, char **argv) {
  const struct winsize size = {.ws_row = 24, .ws_col = 80};
  int inside;
  if (argc < 3 || openpty(&terminal, &inside, NULL, NULL, &size) != 0) return 2;
  clear_screen();
  (void)setvbuf(stdout, NULL, _IOLBF, 0);
  (void)tcgetattr(terminal, &before);
  program = fork();
  if (program == 0) {
    (void)close(terminal);
    if (login_tty(inside) != 0) _exit(126);
    (void)execvp(argv[2], argv + 2);
    _exit(127);
  }
  /* the inner end stays open, so that the terminal outlives the program and can be looked at */
  run_script(argv[1]);
  report();
  return 0;
}
