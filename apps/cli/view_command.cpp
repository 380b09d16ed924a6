// graze view: the lab in a browser, with a file in its viewer.
#include "commands.hpp"
#include "graze/error.hpp"

#ifdef GRAZE_HAS_SERVER
#include <fcntl.h>
#include <fmt/format.h>
#include <httplib.h>
#include <pthread.h>
#include <spawn.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <memory>
#include <thread>

#include "lab_files.hpp"
#include "output.hpp"
#endif

namespace graze::cli {

namespace {

struct ViewArguments {
  std::string file, lab;
  int port = 0;
  bool no_open = false;
};

#ifdef GRAZE_HAS_SERVER

constexpr const char* loopback = "127.0.0.1";

/// A header that came once; one that came more often counts as foreign, since it is not known which is valid.
std::string header(const httplib::Request& request, const char* name) {
  return request.get_header_value_count(name) > 1 ? "more than one" : request.get_header_value(name);
}

LabRequest request_of(const httplib::Request& r) {
  return {r.method,
          r.path,
          header(r, "Host"),
          header(r, "Origin"),
          header(r, "Sec-Fetch-Site"),
          header(r, "If-None-Match")};
}

void send(const LabAnswer& answer, httplib::Response& response) {
  response.status = answer.status;
  // The page's own policy, and headers that a page cannot set for itself.
  response.set_header("Content-Security-Policy", "frame-ancestors 'none'");
  response.set_header("Cross-Origin-Resource-Policy", "same-origin");
  response.set_header("X-Content-Type-Options", "nosniff");
  response.set_header("Referrer-Policy", "no-referrer");
  response.set_header("Cache-Control", answer.version.empty() ? "no-store" : "no-cache");
  if (!answer.version.empty()) response.set_header("ETag", answer.version);
  if (answer.status == 405) response.set_header("Allow", "GET, HEAD");
  if (answer.status != 304) response.set_content(answer.body, answer.type);
}

/// A server on the loopback address alone, from its making to its end.
class LabServer {
 public:
  LabServer(const LabFiles& files, int port) {
    // Two programs at one port would share its requests, which is the default of the package.
    server_.set_socket_options([](socket_t socket) {
      const int yes = 1;
      setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    server_.set_payload_max_length(0);
    server_.set_keep_alive_max_count(100);
    server_.set_read_timeout(1);
    server_.set_write_timeout(30);
    server_.set_pre_routing_handler([&files, this](const httplib::Request& request, httplib::Response& response) {
      send(files.answer(request_of(request), port_), response);
      return httplib::Server::HandlerResponse::Handled;
    });
    port_ = port == 0 ? server_.bind_to_any_port(loopback) : server_.bind_to_port(loopback, port) ? port : -1;
    if (port_ <= 0) {
      if (port == 0) throw InvalidValue(loopback, "a free port", "there is none");
      throw InvalidValue("--port", "a port that this program may take",
                         fmt::format("{}, which is in use or reserved", port));
    }
    thread_ = std::thread([this] {
      server_.listen_after_bind();
      ended_ = true;
    });
  }
  ~LabServer() {
    // A server that has not begun to listen cannot be stopped yet.
    while (!server_.is_running() && !ended_) std::this_thread::yield();
    server_.stop();
    thread_.join();
  }
  LabServer(const LabServer&) = delete;
  LabServer& operator=(const LabServer&) = delete;

  std::string address() const { return fmt::format("http://{}:{}", loopback, port_); }

 private:
  httplib::Server server_;
  int port_ = 0;
  std::atomic<bool> ended_ = false;
  std::thread thread_;
};

/// Shows the address in the desktop's browser, if there is a desktop. The output of that browser is not shown.
void open_browser(const std::string& address) {
  if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) return;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (const int out : {STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&actions, out, "/dev/null", O_WRONLY, 0);
  std::string program = "xdg-open", where = address;
  char* arguments[] = {program.data(), where.data(), nullptr};
  pid_t child = 0;
  posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
}

int run_view(const ViewArguments& options) {
  // Signals are blocked before there are threads, so that none but `sigwait` gets them.
  sigset_t stops;
  sigemptyset(&stops);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&stops, signal);
  pthread_sigmask(SIG_BLOCK, &stops, nullptr);
  std::signal(SIGPIPE, SIG_IGN);

  const LabFiles files(find_lab(options.lab), options.file);
  const LabServer server(files, options.port);
  const std::string address = server.address() + files.page();
  fmt::print("{}\n", address);
  flush_output();
  print_notes({fmt::format("{} is shown there, and again whenever it changes; Ctrl-C ends it", options.file)});
  if (!options.no_open) open_browser(address);
  int signal = 0;
  sigwait(&stops, &signal);
  return 0;
}

#else

int run_view(const ViewArguments&) {
  throw InvalidValue("graze view", "a program built with cpp-httplib (libcpp-httplib-dev)", "one without it");
}

#endif

}  // namespace

Run add_view(CLI::App& app) {
  auto options = std::make_shared<ViewArguments>();
  CLI::App* command = app.add_subcommand("view", "Show a file in the lab's viewer, in a browser");
  command
      ->add_option("FILE", options->file,
                   "A scene or mesh: glTF, OBJ, STL or PLY; a scene of the plane: .svg or .json; a question as JSON; a "
                   "capture")
      ->required();
  command->add_option("--port", options->port, "The port to serve at (default: a free one)")
      ->check(CLI::Range(1, 65535));
  command->add_flag("--no-open", options->no_open, "Only print the address, open no browser");
  command->add_option("--lab", options->lab,
                      "The folder of the built lab (default: the installed one, or this tree's)");
  command->footer("Serves the lab and this one file on the loopback address, to this machine's browser alone, until\n"
                  "Ctrl-C; the page shows the file anew whenever it changes.\n\n"
                  "Exit code: 0, or 2 when the file, the lab or the port is at fault.\n\n"
                  "Example:\n"
                  "  graze view examples/scenes/demo.gltf --port 8080");
  return [options] { return run_view(*options); };
}

}  // namespace graze::cli
