/* SPDX-License-Identifier: MIT */
/* The host's loop brings messages at any time. They wait in the window until its owner takes them,
 * as events of X11 wait in their connection: so nothing happens to an owner that draws. */
#include "window/native_window.h"

#include <cairo-win32.h>
#include <stdio.h>
#include <stdlib.h>
#include <windows.h>
#include <windowsx.h>

#include "window/windows_keyboard.h"

typedef enum EventKind { PRESS, DRAG, RELEASE, MENU, HOVER, SCROLL, PRESS_KEY } EventKind;

typedef struct Event {
  EventKind kind;
  int x, y;
  int steps;         /* of the wheel */
  NativeTouch touch; /* is_fine of a key: it has Shift */
  Key key;
} Event;

enum { MOST_EVENTS = 64 }; /* at once */
enum { NAME_LENGTH = 40 }; /* of a class of windows, terminated */
enum { TICKS = 1 };        /* number of the timer */

struct NativeWindow {
  NativeHandler handler;
  HWND id; /* NULL: it has gone with the outer window */
  cairo_surface_t *picture;
  uint32_t width, height;
  bool shown, held, is_tracked;
  int wheel; /* what is left of a step */
  WindowsKeyboard keyboard;
  Event events[MOST_EVENTS];
  uint32_t event_count;
};

/* ---- events --------------------------------------------------------------------------------- */

static bool is_motion(const Event *event) { return event->kind == DRAG || event->kind == HOVER; }

/* Of motions that follow each other the last one counts; so does the last event of too many. */
static void add(NativeWindow *window, Event event) {
  const uint32_t count = window->event_count;
  const bool follows = count > 0 && window->events[count - 1].kind == event.kind;
  const bool replaces = (follows && is_motion(&event)) || count == MOST_EVENTS;
  window->events[replaces ? count - 1 : count] = event;
  window->event_count = replaces ? count : count + 1;
}

static void tell(const NativeWindow *window, const Event *event) {
  const NativeHandler *const handler = &window->handler;
  void *const context = handler->context;
  switch (event->kind) {
  case PRESS: handler->press(context, event->x, event->y, event->touch); break;
  case DRAG: handler->drag(context, event->x, event->y, event->touch); break;
  case RELEASE: handler->release(context); break;
  case MENU: handler->menu(context, event->x, event->y); break;
  case HOVER: handler->hover(context, event->x, event->y); break;
  case SCROLL: handler->scroll(context, event->x, event->y, event->steps, event->touch); break;
  case PRESS_KEY: handler->key(context, event->key, event->touch.is_fine); break;
  }
}

/* A host's menu has a loop of its own, which may bring more of them. */
void native_window_take_events(NativeWindow *window) {
  Event events[MOST_EVENTS];
  const uint32_t count = window->event_count;
  for (uint32_t i = 0; i < count; i++) events[i] = window->events[i];
  window->event_count = 0;
  for (uint32_t i = 0; i < count; i++) tell(window, &events[i]);
}

/* ---- messages ------------------------------------------------------------------------------- */

static Event at_place(EventKind kind, WPARAM state, LPARAM place) {
  return (Event){.kind = kind,
                 .x = GET_X_LPARAM(place),
                 .y = GET_Y_LPARAM(place),
                 .touch = {.is_fine = (state & MK_SHIFT) != 0}};
}

/* A click asks for the keys, which a host's own window has at first; the mouse stays with the
 * window while its button is held. */
static void take_press(NativeWindow *window, WPARAM state, LPARAM place, bool is_again) {
  Event event = at_place(PRESS, state, place);
  event.touch.is_again = is_again;
  (void)SetFocus(window->id);
  (void)SetCapture(window->id);
  window->held = true;
  add(window, event);
}

static void take_release(NativeWindow *window) {
  if (!window->held) return;
  window->held = false;
  if (GetCapture() == window->id) (void)ReleaseCapture();
  add(window, (Event){.kind = RELEASE});
}

static void take_motion(NativeWindow *window, WPARAM state, LPARAM place) {
  TRACKMOUSEEVENT leave = {.cbSize = sizeof leave, .dwFlags = TME_LEAVE, .hwndTrack = window->id};
  if (!window->is_tracked) window->is_tracked = TrackMouseEvent(&leave) != 0;
  add(window, at_place(window->held ? DRAG : HOVER, state, place));
}

static void take_leave(NativeWindow *window) {
  window->is_tracked = false;
  if (!window->held) add(window, (Event){.kind = HOVER, .x = -1, .y = -1});
}

/* Its place is one of the screen. Fine wheels turn by parts of a step. */
static void take_wheel(NativeWindow *window, WPARAM turned, LPARAM place) {
  POINT point = {GET_X_LPARAM(place), GET_Y_LPARAM(place)};
  window->wheel += GET_WHEEL_DELTA_WPARAM(turned);
  (void)ScreenToClient(window->id, &point);
  for (; abs(window->wheel) >= WHEEL_DELTA;
       window->wheel -= window->wheel > 0 ? WHEEL_DELTA : -WHEEL_DELTA) {
    Event event = at_place(SCROLL, GET_KEYSTATE_WPARAM(turned), MAKELPARAM(point.x, point.y));
    event.steps = window->wheel > 0 ? 1 : -1;
    add(window, event);
  }
}

static void take_key(NativeWindow *window, Key key) {
  const bool has_shift = windows_keyboard_has_shift();
  if (key != KEY_UNKNOWN)
    add(window, (Event){.kind = PRESS_KEY, .key = key, .touch = {.is_fine = has_shift}});
}

/* What was drawn last. */
static void copy_picture(const NativeWindow *window, HDC target) {
  cairo_surface_flush(window->picture);
  (void)BitBlt(target, 0, 0, (int)window->width, (int)window->height,
               cairo_win32_surface_get_dc(window->picture), 0, 0, SRCCOPY);
}

static void paint(const NativeWindow *window) {
  PAINTSTRUCT painting;
  copy_picture(window, BeginPaint(window->id, &painting));
  (void)EndPaint(window->id, &painting);
}

/* False if it is for Windows. */
static bool take_message(NativeWindow *window, UINT message, WPARAM first, LPARAM second) {
  switch (message) {
  case WM_LBUTTONDOWN: take_press(window, first, second, false); return true;
  case WM_LBUTTONDBLCLK: take_press(window, first, second, true); return true;
  case WM_LBUTTONUP:
  case WM_CAPTURECHANGED: take_release(window); return true;
  case WM_RBUTTONDOWN: add(window, at_place(MENU, first, second)); return true;
  case WM_MOUSEMOVE: take_motion(window, first, second); return true;
  case WM_MOUSELEAVE: take_leave(window); return true;
  case WM_MOUSEWHEEL: take_wheel(window, first, second); return true;
  case WM_KEYDOWN: take_key(window, windows_keyboard_key(&window->keyboard, first)); return true;
  case WM_CHAR: take_key(window, windows_keyboard_character(&window->keyboard, first)); return true;
  case WM_TIMER: window->handler.tick(window->handler.context); return true;
  case WM_PAINT: paint(window); return true;
  case WM_PRINTCLIENT: copy_picture(window, (HDC)first); return true;
  default: return false;
  }
}

/* The background is part of the picture. Keys are for the window, even if the outer one is a
 * dialog. */
static LRESULT CALLBACK on_message(HWND id, UINT message, WPARAM first, LPARAM second) {
  NativeWindow *const window = (NativeWindow *)GetWindowLongPtrW(id, GWLP_USERDATA);
  if (message == WM_ERASEBKGND) return 1;
  if (message == WM_GETDLGCODE) return DLGC_WANTALLKEYS;
  if (window && message == WM_NCDESTROY) {
    (void)SetWindowLongPtrW(id, GWLP_USERDATA, 0);
    window->id = NULL;
  } else if (window && take_message(window, message, first, second)) {
    return 0;
  }
  return DefWindowProcW(id, message, first, second);
}

/* ---- the window ----------------------------------------------------------------------------- */

/* The binary that this is part of. */
static HINSTANCE module(void) {
  static const WCHAR inside[] = L"an address of it";
  HMODULE found = NULL;
  (void)GetModuleHandleExW(GET_MODULE_HANDLE_EX_FLAG_FROM_ADDRESS |
                             GET_MODULE_HANDLE_EX_FLAG_UNCHANGED_REFCOUNT,
                           inside, &found);
  return found;
}

/* The name of the class of windows, another one for each binary. */
static const WCHAR *class_name(WCHAR name[NAME_LENGTH]) {
  (void)swprintf(name, NAME_LENGTH, L"Tabor %p", (void *)module());
  return name;
}

static bool make_picture(NativeWindow *window) {
  cairo_surface_destroy(window->picture);
  window->picture = cairo_win32_surface_create_with_dib(CAIRO_FORMAT_RGB24, (int)window->width,
                                                        (int)window->height);
  return cairo_surface_status(window->picture) == CAIRO_STATUS_SUCCESS;
}

/* The class is there already if another window is open. */
static bool open_window(NativeWindow *window, HWND parent) {
  WCHAR name[NAME_LENGTH];
  const WNDCLASSEXW class = {.cbSize = sizeof class,
                             .style = CS_DBLCLKS,
                             .lpfnWndProc = on_message,
                             .hInstance = module(),
                             .hCursor = LoadCursorW(NULL, (LPCWSTR)IDC_ARROW),
                             .lpszClassName = class_name(name)};
  (void)RegisterClassExW(&class);
  window->id =
    CreateWindowExW(0, name, L"Tabor", WS_CHILD | WS_CLIPSIBLINGS, 0, 0, (int)window->width,
                    (int)window->height, parent, NULL, module(), NULL);
  if (!window->id) return false;
  (void)SetWindowLongPtrW(window->id, GWLP_USERDATA, (LONG_PTR)window);
  return make_picture(window);
}

NativeWindow *native_window_create(uintptr_t parent, uint32_t width, uint32_t height,
                                   const NativeHandler *handler) {
  NativeWindow *const window = calloc(1, sizeof *window);
  if (!window) return NULL;
  window->handler = *handler;
  window->width = width;
  window->height = height;
  if (open_window(window, (HWND)parent)) return window;
  native_window_destroy(window);
  return NULL;
}

/* The class goes with the last window: Windows keeps it while there is another one. */
void native_window_destroy(NativeWindow *window) {
  WCHAR name[NAME_LENGTH];
  if (!window) return;
  if (window->id) (void)DestroyWindow(window->id);
  (void)UnregisterClassW(class_name(name), module());
  cairo_surface_destroy(window->picture);
  free(window);
}

uintptr_t native_window_id(const NativeWindow *window) { return (uintptr_t)window->id; }

void native_window_show(NativeWindow *window, bool shown) {
  window->shown = shown;
  (void)ShowWindow(window->id, shown ? SW_SHOWNA : SW_HIDE);
}

void native_window_resize(NativeWindow *window, uint32_t width, uint32_t height) {
  window->width = width;
  window->height = height;
  (void)make_picture(window);
  (void)SetWindowPos(window->id, NULL, 0, 0, (int)width, (int)height,
                     SWP_NOMOVE | SWP_NOZORDER | SWP_NOACTIVATE);
}

void native_window_draw(NativeWindow *window) {
  if (!window->shown || !window->id) return;
  cairo_t *const cairo = cairo_create(window->picture);
  window->handler.draw(window->handler.context, cairo, window->width, window->height);
  cairo_destroy(cairo);
  (void)InvalidateRect(window->id, NULL, FALSE);
  (void)UpdateWindow(window->id);
}

bool native_window_has_ticks(void) { return true; }

bool native_window_start_ticks(NativeWindow *window, uint32_t period) {
  return SetTimer(window->id, TICKS, period, NULL) != 0;
}
