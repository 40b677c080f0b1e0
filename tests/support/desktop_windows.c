/* SPDX-License-Identifier: MIT */
/* Messages that Windows would send: the test needs neither a pointer nor a screen. */
#include "desktop.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <windows.h>

#include <cmocka.h>

static const WCHAR class_name[] = L"Tabor's outer window";

void desktop_settle(Desktop *desktop) {
  (void)desktop;
  MSG message;
  while (PeekMessageW(&message, NULL, 0, 0, PM_REMOVE)) DispatchMessageW(&message);
}

bool desktop_start(Desktop *desktop) {
  const WNDCLASSW class = {.lpfnWndProc = DefWindowProcW, .lpszClassName = class_name};
  assert_true(RegisterClassW(&class) != 0);
  const DesktopWindow window = desktop_window(desktop, 10, 10);
  if (window) desktop_close(desktop, window);
  return window != 0;
}

void desktop_stop(Desktop *desktop) { (void)desktop; }

DesktopWindow desktop_window(Desktop *desktop, uint16_t width, uint16_t height) {
  const HWND window = CreateWindowExW(0, class_name, L"outer", WS_POPUP | WS_VISIBLE, 0, 0, width,
                                      height, NULL, NULL, NULL, NULL);
  desktop_settle(desktop);
  return (DesktopWindow)window;
}

void desktop_close(Desktop *desktop, DesktopWindow window) {
  (void)DestroyWindow((HWND)window);
  desktop_settle(desktop);
}

DesktopWindow desktop_inner(Desktop *desktop, DesktopWindow window) {
  (void)desktop;
  return (DesktopWindow)GetWindow((HWND)window, GW_CHILD);
}

/* The second of two presses at a place comes under a name of its own. */
static UINT press_of(Desktop *desktop, int x, int y) {
  const bool is_soon = desktop->pressed != 0 && desktop->time - desktop->pressed <= 400;
  const bool is_again = is_soon && x == desktop->pressed_x && y == desktop->pressed_y;
  desktop->pressed = is_again ? 0 : desktop->time;
  desktop->pressed_x = x;
  desktop->pressed_y = y;
  return is_again ? WM_LBUTTONDBLCLK : WM_LBUTTONDOWN;
}

void desktop_point(Desktop *desktop, DesktopWindow window, DesktopAct act, DesktopButton button,
                   int x, int y) {
  const bool is_right = button == DESKTOP_RIGHT;
  UINT message = WM_MOUSEMOVE;
  if (act == DESKTOP_PRESS) message = is_right ? WM_RBUTTONDOWN : press_of(desktop, x, y);
  if (act == DESKTOP_RELEASE) message = is_right ? WM_RBUTTONUP : WM_LBUTTONUP;
  (void)SendMessageW((HWND)window, message, 0, MAKELPARAM(x, y));
}

void desktop_wheel(Desktop *desktop, DesktopWindow window, int x, int y, int steps) {
  POINT place = {x, y};
  (void)desktop;
  (void)ClientToScreen((HWND)window, &place);
  for (int i = 0; i < abs(steps); i++) {
    const WPARAM turn = MAKEWPARAM(0, steps > 0 ? WHEEL_DELTA : -WHEEL_DELTA);
    (void)SendMessageW((HWND)window, WM_MOUSEWHEEL, turn, MAKELPARAM(place.x, place.y));
  }
}

/* ---- keys ----------------------------------------------------------------------------------- */

typedef struct NamedKey {
  const char *name;
  WPARAM code;
  char character; /* or 0 */
} NamedKey;

static const NamedKey named[] = {
  {"Escape", VK_ESCAPE, 27},    {"Return", VK_RETURN, 13},
  {"BackSpace", VK_BACK, 8},    {"Tab", VK_TAB, 9},
  {"Delete", VK_DELETE, 0},     {"Up", VK_UP, 0},
  {"Down", VK_DOWN, 0},         {"Left", VK_LEFT, 0},
  {"Right", VK_RIGHT, 0},       {"Home", VK_HOME, 0},
  {"End", VK_END, 0},           {"Page_Up", VK_PRIOR, 0},
  {"Prior", VK_PRIOR, 0},       {"Next", VK_NEXT, 0},
  {"Page_Down", VK_NEXT, 0},    {"period", VK_OEM_PERIOD, '.'},
  {"comma", VK_OEM_COMMA, ','}, {"minus", VK_OEM_MINUS, '-'},
  {"plus", VK_OEM_PLUS, '+'},   {"space", VK_SPACE, ' '},
  {"slash", VK_OEM_2, '/'},     {"question", VK_OEM_2, '?'},
};

static NamedKey key_of(const char *name) {
  for (size_t i = 0; i < sizeof named / sizeof *named; i++)
    if (strcmp(named[i].name, name) == 0) return named[i];
  assert_int_equal(strlen(name), 1);
  return (NamedKey){name, (WPARAM)(VkKeyScanW((WCHAR)name[0]) & 0xff), name[0]};
}

static void hold(unsigned held) {
  BYTE keys[256] = {0};
  if (held & DESKTOP_SHIFT) keys[VK_SHIFT] = 0x80;
  if (held & DESKTOP_CONTROL) keys[VK_CONTROL] = 0x80;
  assert_true(SetKeyboardState(keys));
}

void desktop_key(Desktop *desktop, DesktopWindow window, const char *name, unsigned held) {
  const NamedKey key = key_of(name);
  const bool is_control = held & DESKTOP_CONTROL && key.character >= '@';
  (void)desktop;
  hold(held);
  (void)SendMessageW((HWND)window, WM_KEYDOWN, key.code, 0);
  if (key.character != 0) {
    const WPARAM character = is_control ? key.character & 0x1f : key.character;
    (void)SendMessageW((HWND)window, WM_CHAR, character, 0);
  }
  (void)SendMessageW((HWND)window, WM_KEYUP, key.code, 0);
  hold(0);
}

/* ---- pictures ------------------------------------------------------------------------------- */

/* What a window prints of itself, with a black background. */
typedef struct Print {
  HDC target;
  HBITMAP bitmap;
  uint32_t width, height;
  const uint32_t *pixels; /* 0xRRGGBB */
} Print;

static Print print(DesktopWindow window) {
  RECT size;
  Print made = {.target = CreateCompatibleDC(NULL)};
  assert_true(GetClientRect((HWND)window, &size));
  made.width = (uint32_t)size.right;
  made.height = (uint32_t)size.bottom;
  const BITMAPINFO form = {.bmiHeader = {.biSize = sizeof form.bmiHeader,
                                         .biWidth = size.right,
                                         .biHeight = -size.bottom,
                                         .biPlanes = 1,
                                         .biBitCount = 32}};
  void *pixels = NULL;
  made.bitmap = CreateDIBSection(made.target, &form, DIB_RGB_COLORS, &pixels, NULL, 0);
  assert_non_null(made.bitmap);
  (void)SelectObject(made.target, made.bitmap);
  (void)SendMessageW((HWND)window, WM_PRINTCLIENT, (WPARAM)made.target, PRF_CLIENT);
  (void)GdiFlush();
  made.pixels = pixels;
  return made;
}

static void forget(const Print *made) {
  (void)DeleteDC(made->target);
  (void)DeleteObject(made->bitmap);
}

uint32_t desktop_pixel(Desktop *desktop, DesktopWindow window, int x, int y) {
  (void)desktop;
  const Print made = print(window);
  const uint32_t color = made.pixels[(uint32_t)y * made.width + (uint32_t)x] & 0xffffff;
  forget(&made);
  return color;
}

static void write_picture(const Print *made, FILE *file) {
  (void)fprintf(file, "P6 %u %u 255\n", (unsigned)made->width, (unsigned)made->height);
  for (uint32_t i = 0; i < made->width * made->height; i++) {
    const uint32_t color = made->pixels[i];
    const uint8_t bytes[] = {(uint8_t)(color >> 16), (uint8_t)(color >> 8), (uint8_t)color};
    (void)fwrite(bytes, 1, sizeof bytes, file);
  }
}

/* A PPM of what is inside. */
void keep_picture(DesktopWindow window, const char *name) {
  char path[256];
  const char *const folder = getenv("PICTURES");
  if (!folder) return;
  (void)snprintf(path, sizeof path, "%s/%s.ppm", folder, name);
  FILE *const file = fopen(path, "wb");
  assert_non_null(file);
  const Print made = print((DesktopWindow)GetWindow((HWND)window, GW_CHILD));
  write_picture(&made, file);
  forget(&made);
  assert_int_equal(fclose(file), 0);
}

long open_files(void) {
  const HANDLE process = GetCurrentProcess();
  return (long)(GetGuiResources(process, GR_GDIOBJECTS) + GetGuiResources(process, GR_USEROBJECTS));
}
