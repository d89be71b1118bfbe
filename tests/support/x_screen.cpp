#include "tests/support/x_screen.h"

#include <X11/XKBlib.h>
#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/extensions/XTest.h>
#include <X11/keysym.h>
#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <stdexcept>
#include <utility>
#include <vector>

namespace aomd::test {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::seconds patience{120};

/// The number that Xvfb writes once it takes connections; -1 when it ends instead.
int display_number(int pipe) {
  std::string digits;
  for (char c = 0;;) {
    pollfd wait{pipe, POLLIN, 0};
    if (::poll(&wait, 1, 120'000) != 1 || ::read(pipe, &c, 1) != 1) return -1;
    if (c == '\n') return std::stoi(digits);
    digits += c;
  }
}

/// A window that vanishes between two requests is no reason to end the test program.
int ignore_error(Display*, XErrorEvent*) { return 0; }

}  // namespace

struct XScreen::Connection {
  explicit Connection(const std::string& name) : display(::XOpenDisplay(name.c_str())) {
    if (display == nullptr) throw std::runtime_error("Xvfb takes no connection");
    ::XSetErrorHandler(ignore_error);
    root = DefaultRootWindow(display);
    ::XSelectInput(display, root, SubstructureNotifyMask);  // answers to pings arrive here
    source = ::XCreateSimpleWindow(display, root, 0, 0, 1, 1, 0, 0, 0);
  }
  ~Connection() { ::XCloseDisplay(display); }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  [[nodiscard]] Atom atom(const char* name) const { return ::XInternAtom(display, name, False); }

  void send(const char* type, const std::array<long, 5>& data) {
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = window;
    event.xclient.message_type = atom(type);
    event.xclient.format = 32;
    for (std::size_t i = 0; i < data.size(); ++i) event.xclient.data.l[i] = data[i];
    ::XSendEvent(display, window, False, NoEventMask, &event);
    ::XFlush(display);
  }

  /// The next event before `end`; false when there is none.
  bool next(XEvent& event, Clock::time_point end) {
    while (::XPending(display) == 0) {
      const auto left =
          std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
      pollfd wait{ConnectionNumber(display), POLLIN, 0};
      if (left <= 0 || ::poll(&wait, 1, static_cast<int>(left)) < 0) return false;
    }
    ::XNextEvent(display, &event);
    return true;
  }

  bool answers_ping() {
    const long number = ++pings;
    send("WM_PROTOCOLS",
         {static_cast<long>(atom("_NET_WM_PING")), number, static_cast<long>(window), 0, 0});
    XEvent event{};
    for (const auto end = Clock::now() + patience; next(event, end);)
      if (event.type == ClientMessage && event.xclient.message_type == atom("WM_PROTOCOLS") &&
          event.xclient.data.l[1] == number)
        return true;
    return false;
  }

  [[nodiscard]] bool is_wanted(Window candidate) const {
    XWindowAttributes attributes{};
    if (::XGetWindowAttributes(display, candidate, &attributes) == 0 ||
        attributes.map_state != IsViewable)
      return false;
    Atom* protocols = nullptr;
    int count = 0;
    if (::XGetWMProtocols(display, candidate, &protocols, &count) == 0) return false;
    ::XFree(protocols);
    return count > 1;
  }

  /// What the window asks for when something is dropped: the list of files.
  void answer(const XSelectionRequestEvent& request, const std::string& text) {
    ::XChangeProperty(display, request.requestor, request.property, request.target, 8,
                      PropModeReplace, reinterpret_cast<const unsigned char*>(text.data()),
                      static_cast<int>(text.size()));
    XEvent event{};
    event.xselection.type = SelectionNotify;
    event.xselection.requestor = request.requestor;
    event.xselection.selection = request.selection;
    event.xselection.target = request.target;
    event.xselection.property = request.property;
    event.xselection.time = request.time;
    ::XSendEvent(display, request.requestor, False, NoEventMask, &event);
    ::XFlush(display);
  }

  Display* display;
  Window root = 0;
  Window window = 0;  ///< the one that is driven
  Window source = 0;  ///< where dragged files come from
  long pings = 0;
};

XScreen::XScreen(glm::ivec2 size, const std::filesystem::path& log) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe to Xvfb");
  const std::string screen = std::to_string(size.x) + "x" + std::to_string(size.y) + "x24";
  const std::vector<std::string> words = {"Xvfb",      "-displayfd", std::to_string(ends[1]),
                                          "-screen",   "0",          screen,
                                          "-nolisten", "tcp",        "-noreset"};
  server_ = std::make_unique<Child>(words, std::vector<std::string>{}, log, ends[1]);
  ::close(ends[1]);
  const int number = display_number(ends[0]);
  ::close(ends[0]);
  if (number < 0) throw std::runtime_error("there is no Xvfb here, or it does not start");
  name_ = ":" + std::to_string(number);
  x_ = std::make_unique<Connection>(name_);
}

XScreen::~XScreen() = default;

bool XScreen::find_window() {
  Window root = 0, parent = 0;
  Window* children = nullptr;
  unsigned count = 0;
  if (::XQueryTree(x_->display, x_->root, &root, &parent, &children, &count) == 0) return false;
  x_->window = 0;
  for (unsigned i = 0; i < count; ++i)
    if (x_->is_wanted(children[i])) x_->window = children[i];
  if (children != nullptr) ::XFree(children);
  if (x_->window == 0) return false;
  ::XMoveWindow(x_->display, x_->window, 0, 0);
  ::XSetInputFocus(x_->display, x_->window, RevertToParent, CurrentTime);
  ::XSync(x_->display, False);
  return true;
}

std::string XScreen::title() const {
  XTextProperty property{};
  const Atom name = x_->atom("_NET_WM_NAME");
  if (::XGetTextProperty(x_->display, x_->window, &property, name) == 0 ||
      property.value == nullptr)
    return {};
  std::string title(reinterpret_cast<const char*>(property.value), property.nitems);
  ::XFree(property.value);
  return title;
}

bool XScreen::settle(int frames) {
  for (int i = 0; i < frames; ++i)
    if (!x_->answers_ping()) return false;
  return true;
}

void XScreen::move_mouse(glm::ivec2 to) {
  ::XWarpPointer(x_->display, 0, x_->window, 0, 0, 0, 0, to.x, to.y);
  ::XFlush(x_->display);
}

void XScreen::button(unsigned number, bool down) {
  ::XTestFakeButtonEvent(x_->display, number, down ? True : False, CurrentTime);
  ::XFlush(x_->display);
}

void XScreen::key(unsigned long symbol, bool down) {
  const KeyCode code = ::XKeysymToKeycode(x_->display, symbol);
  if (code == 0) throw std::runtime_error("no key for symbol " + std::to_string(symbol));
  ::XTestFakeKeyEvent(x_->display, code, down ? True : False, CurrentTime);
  ::XFlush(x_->display);
}

void XScreen::press(std::string_view chord) {
  constexpr std::array<std::pair<std::string_view, KeySym>, 3> modifiers = {
      {{"Ctrl+", XK_Control_L}, {"Shift+", XK_Shift_L}, {"Alt+", XK_Alt_L}}};
  std::vector<KeySym> held;
  for (const auto& [word, symbol] : modifiers)
    if (chord.starts_with(word)) {
      chord.remove_prefix(word.size());
      held.push_back(symbol);
    }
  const KeySym last = ::XStringToKeysym(std::string(chord).c_str());
  for (const KeySym modifier : held) key(modifier, true);
  key(last, true);
  key(last, false);
  for (const KeySym modifier : held) key(modifier, false);
}

void XScreen::type(std::string_view text) {
  for (const char c : text) {
    const KeySym symbol = static_cast<unsigned char>(c);  // Latin 1 is numbered as it is
    const KeyCode code = ::XKeysymToKeycode(x_->display, symbol);
    const bool shift = ::XkbKeycodeToKeysym(x_->display, code, 0, 0) != symbol;
    if (shift) key(XK_Shift_L, true);
    key(symbol, true);
    key(symbol, false);
    if (shift) key(XK_Shift_L, false);
  }
}

void XScreen::resize(glm::ivec2 size) {
  ::XResizeWindow(x_->display, x_->window, static_cast<unsigned>(size.x),
                  static_cast<unsigned>(size.y));
  ::XSync(x_->display, False);
}

void XScreen::ask_to_close() {
  x_->send("WM_PROTOCOLS", {static_cast<long>(x_->atom("WM_DELETE_WINDOW")), 0, 0, 0, 0});
}

bool XScreen::drop_file(const std::filesystem::path& file, glm::ivec2 to) {
  const long source = static_cast<long>(x_->source);
  const long list = static_cast<long>(x_->atom("text/uri-list"));
  constexpr long version = 5L << 24;
  move_mouse(to);
  ::XSetSelectionOwner(x_->display, x_->atom("XdndSelection"), x_->source, CurrentTime);
  x_->send("XdndEnter", {source, version, list, 0, 0});
  x_->send("XdndPosition", {source, 0, to.x << 16 | to.y, CurrentTime,
                            static_cast<long>(x_->atom("XdndActionCopy"))});
  x_->send("XdndDrop", {source, 0, CurrentTime, 0, 0});
  bool asked = false;
  XEvent event{};
  for (const auto end = Clock::now() + patience; x_->next(event, end);) {
    if (event.type == SelectionRequest) {
      x_->answer(event.xselectionrequest, "file://" + file.string() + "\r\n");
      asked = true;
    }
    const bool finished =
        event.type == ClientMessage && event.xclient.message_type == x_->atom("XdndFinished");
    if (finished) return asked;
  }
  return false;
}

}  // namespace aomd::test
