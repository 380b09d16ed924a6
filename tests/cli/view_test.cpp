// `graze view` as a browser and as an attacker meet it: requests byte by byte, over the loopback address.
#include <gtest/gtest.h>

#include <arpa/inet.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "run_program.hpp"

namespace {

using graze::cli::run;
namespace fs = std::filesystem;

void write_text(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }

/// A folder with a lab of three files, a scene beside it, and a secret; gone at the end.
struct ViewFolder {
  fs::path root, lab, scene;

  ViewFolder() {
    std::string name = (fs::temp_directory_path() / "graze_view_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no folder for the test");
    root = name;
    lab = root / "lab";
    scene = root / "my scene.obj";
    fs::create_directories(lab / "assets");
    write_text(lab / "index.html", "<p>the lab</p>");
    write_text(lab / "assets/main.js", "run()");
    write_text(root / "secret.txt", "SECRET");
    write_text(scene, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    fs::create_symlink(root / "secret.txt", lab / "link.txt");
    fs::create_directory_symlink(root, lab / "up");
  }
  ~ViewFolder() { fs::remove_all(root); }
  ViewFolder(const ViewFolder&) = delete;
  ViewFolder& operator=(const ViewFolder&) = delete;
};

/// The program while it serves.
class Viewing {
 public:
  explicit Viewing(const ViewFolder& folder) {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe");
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_addclose(&actions, ends[0]);
    std::string words[] = {GRAZE_CLI_PATH, "view",  folder.scene.string(), "--no-open",
                           "-q",           "--lab", folder.lab.string()};
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    if (posix_spawn(&child_, GRAZE_CLI_PATH, &actions, nullptr, arguments.data(), environ) != 0)
      throw std::runtime_error("the program does not start");
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    for (char c = 0; read(ends[0], &c, 1) == 1 && c != '\n';) address_ += c;
    close(ends[0]);
    const std::size_t colon = address_.find(':', address_.find("127.0.0.1"));
    port_ = colon == std::string::npos ? 0 : std::stoi(address_.substr(colon + 1));
  }
  ~Viewing() {
    if (child_ > 0) end(SIGKILL);
  }
  Viewing(const Viewing&) = delete;
  Viewing& operator=(const Viewing&) = delete;

  const std::string& address() const { return address_; }
  int port() const { return port_; }
  std::string host() const { return "127.0.0.1:" + std::to_string(port_); }

  /// Sends bytes as they are and returns all that comes back.
  std::string raw(const std::string& bytes) const {
    const int s = socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(static_cast<std::uint16_t>(port_));
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    std::string all;
    if (connect(s, reinterpret_cast<const sockaddr*>(&to), sizeof to) == 0 &&
        send(s, bytes.data(), bytes.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(bytes.size())) {
      char part[4096];
      for (ssize_t n = 0; (n = recv(s, part, sizeof part, 0)) > 0;) all.append(part, static_cast<std::size_t>(n));
    }
    close(s);
    return all;
  }
  std::string get(const std::string& target, const std::string& more = "", const std::string& method = "GET") const {
    return raw(method + " " + target + " HTTP/1.1\r\nHost: " + host() + "\r\n" + more + "Connection: close\r\n\r\n");
  }
  /// Its exit code after a signal, or what stopped it, negative.
  int end(int signal) {
    kill(child_, signal);
    int status = 0;
    waitpid(child_, &status, 0);
    child_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

 private:
  pid_t child_ = 0;
  std::string address_;
  int port_ = 0;
};

int status_of(const std::string& answer) { return answer.size() > 12 ? std::stoi(answer.substr(9, 3)) : 0; }

std::string header_of(const std::string& answer, const std::string& name) {
  const std::size_t at = answer.find("\r\n" + name + ": ");
  if (at == std::string::npos || at > answer.find("\r\n\r\n")) return "";
  const std::size_t begin = at + 4 + name.size();
  return answer.substr(begin, answer.find("\r\n", begin) - begin);
}

TEST(View, ServesTheLabAndTheFileAndEndsByCtrlC) {
  const ViewFolder folder;
  Viewing viewing(folder);
  EXPECT_EQ(viewing.address(), "http://" + viewing.host() + "/#/scene?file=file%2Fmy%2520scene.obj");
  const std::string page = viewing.get("/");
  EXPECT_EQ(status_of(page), 200);
  EXPECT_TRUE(page.ends_with("<p>the lab</p>"));
  EXPECT_EQ(header_of(page, "Content-Type"), "text/html; charset=utf-8");
  EXPECT_EQ(header_of(page, "X-Content-Type-Options"), "nosniff");
  EXPECT_EQ(header_of(page, "Access-Control-Allow-Origin"), "");
  EXPECT_EQ(header_of(viewing.get("/assets/main.js"), "Content-Type"), "text/javascript; charset=utf-8");
  EXPECT_TRUE(viewing.get("/file/my%20scene.obj").ends_with("f 1 2 3\n"));
  const std::string head = viewing.get("/", "", "HEAD");
  EXPECT_EQ(status_of(head), 200);
  EXPECT_TRUE(head.ends_with("\r\n\r\n"));
  EXPECT_EQ(viewing.end(SIGINT), 0);
}

TEST(View, GivesAwayNothingElse) {
  const ViewFolder folder;
  const Viewing viewing(folder);
  const std::string secret = (folder.root / "secret.txt").string();
  for (const std::string& target : {std::string("/../secret.txt"),
                                    std::string("/%2e%2e/secret.txt"),
                                    std::string("/assets/../../secret.txt"),
                                    std::string("/file/../secret.txt"),
                                    std::string("/file/secret.txt"),
                                    std::string("/file/..%2fsecret.txt"),
                                    std::string("/file/my%20scene.obj/../../secret.txt"),
                                    std::string("//etc/passwd"),
                                    std::string("/file//etc/passwd"),
                                    std::string("/..%5csecret.txt"),
                                    std::string("/link.txt"),
                                    std::string("/up/secret.txt"),
                                    std::string("/index.html%00.txt"),
                                    std::string("/assets"),
                                    std::string("/assets/"),
                                    std::string("/file/"),
                                    secret,
                                    "/" + secret,
                                    "/file/" + secret,
                                    std::string("secret.txt"),
                                    std::string("*")}) {
    const std::string answer = viewing.get(target);
    EXPECT_EQ(answer.find("SECRET"), std::string::npos) << target;
    EXPECT_EQ(answer.find("root:"), std::string::npos) << target;
    EXPECT_GE(status_of(answer), 400) << target;
  }
  EXPECT_EQ(status_of(viewing.get("/" + std::string(20000, 'a'))), 414);
  EXPECT_EQ(viewing.raw("nothing like a request\r\n\r\n").find("SECRET"), std::string::npos);
  EXPECT_EQ(status_of(viewing.get("/")), 200) << "and goes on serving";
}

/// Four bytes of a buffer in a file of its own, and one more that the scene may not have.
std::string scene_with_buffer(const std::string& uri) {
  return R"({"asset": {"version": "2.0"}, "buffers": [{"uri": ")" + uri + R"(", "byteLength": 4}]})";
}

TEST(View, ASceneCarriesItsBuffersAndChangesWithThem) {
  ViewFolder folder;
  folder.scene = folder.root / "scene.gltf";
  write_text(folder.scene, scene_with_buffer("parts/a%20b.bin"));
  fs::create_directories(folder.root / "parts");
  write_text(folder.root / "parts/a b.bin", "abcd");
  const Viewing viewing(folder);
  const std::string whole = viewing.get("/file/scene.gltf");
  EXPECT_EQ(status_of(whole), 200);
  EXPECT_NE(whole.find("base64,YWJjZA=="), std::string::npos) << whole;
  EXPECT_GE(status_of(viewing.get("/file/parts/a%20b.bin")), 400) << "one file is enough";
  const std::string version = header_of(whole, "ETag");
  EXPECT_EQ(status_of(viewing.get("/file/scene.gltf", "If-None-Match: " + version + "\r\n")), 304);
  write_text(folder.root / "parts/a b.bin", "efghi");
  const std::string later = viewing.get("/file/scene.gltf", "If-None-Match: " + version + "\r\n");
  EXPECT_EQ(status_of(later), 200);
  // A buffer that is not of its length: the page is given the scene as it is, and says what is wrong with it.
  EXPECT_NE(later.find("a%20b.bin"), std::string::npos);
  for (const char* uri : {"../outside.bin", "/etc/passwd", "..%2foutside.bin", "parts/../../outside.bin"}) {
    write_text(folder.root.parent_path() / "outside.bin", "SECR");
    write_text(folder.scene, scene_with_buffer(uri));
    const std::string answer = viewing.get("/file/scene.gltf");
    EXPECT_NE(answer.find(uri), std::string::npos) << answer;
    EXPECT_EQ(answer.find("base64"), std::string::npos) << uri;
    fs::remove(folder.root.parent_path() / "outside.bin");
  }
}

TEST(View, TalksToNoOtherSite) {
  const ViewFolder folder;
  const Viewing viewing(folder);
  const auto with = [&](const std::string& host, const std::string& more = "") {
    return status_of(viewing.raw("GET / HTTP/1.1\r\n" + host + more + "Connection: close\r\n\r\n"));
  };
  const std::string own = "Host: " + viewing.host() + "\r\n", port = std::to_string(viewing.port());
  EXPECT_EQ(with(own), 200);
  EXPECT_EQ(with("Host: localhost:" + port + "\r\n"), 200);
  EXPECT_EQ(with("Host: evil.example:" + port + "\r\n"), 403) << "a name that was made to lead here";
  EXPECT_EQ(with("Host: 127.0.0.1\r\n"), 403);
  EXPECT_EQ(with(""), 403);
  EXPECT_EQ(with(own, own), 403) << "two hosts";
  EXPECT_EQ(with(own, "Origin: http://" + viewing.host() + "\r\n"), 200);
  EXPECT_EQ(with(own, "Origin: http://evil.example\r\n"), 403);
  EXPECT_EQ(with(own, "Origin: null\r\n"), 403);
  EXPECT_EQ(with(own, "Origin: http://localhost:" + port + "\r\n"), 403) << "is another origin";
  EXPECT_EQ(with(own, "Sec-Fetch-Site: same-origin\r\n"), 200);
  EXPECT_EQ(with(own, "Sec-Fetch-Site: cross-site\r\n"), 403) << "a script or picture in a foreign page";
  for (const char* method : {"POST", "PUT", "DELETE", "OPTIONS", "PATCH"}) {
    const int status = status_of(viewing.get("/", "Content-Length: 0\r\n", method));
    EXPECT_EQ(status, 405) << method;
  }
}

TEST(View, TellsWhenTheFileChangesAndWhenItIsGone) {
  const ViewFolder folder;
  const Viewing viewing(folder);
  const std::string target = "/file/my%20scene.obj", first = header_of(viewing.get(target), "ETag");
  ASSERT_FALSE(first.empty());
  const std::string known = "If-None-Match: " + first + "\r\n";
  EXPECT_EQ(status_of(viewing.get(target, known)), 304);
  write_text(folder.scene, "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 2 3\n");
  const std::string changed = viewing.get(target, known);
  EXPECT_EQ(status_of(changed), 200);
  EXPECT_NE(header_of(changed, "ETag"), first);
  EXPECT_NE(changed.find("v 0 0 2"), std::string::npos);
  fs::remove(folder.scene);
  EXPECT_EQ(status_of(viewing.get(target, known)), 404);
  EXPECT_EQ(status_of(viewing.get("/")), 200);
}

TEST(View, AFullDiskIsNoSuccess) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "a system without /dev/full";
  const ViewFolder folder;
  const auto r = run("view '" + folder.scene.string() + "' --no-open --lab " + folder.lab.string() + " > /dev/full");
  EXPECT_EQ(r.code, 2);
  EXPECT_EQ(r.output, "graze: standard output cannot be written: No space left on device\n");
}

TEST(View, SaysWhatIsWrong) {
  const ViewFolder folder;
  const auto says = [&](const std::string& arguments, const std::string& what) {
    const auto r = run("view --no-open " + arguments);
    EXPECT_EQ(r.code, 2) << arguments;
    EXPECT_NE(r.output.find(what), std::string::npos) << r.output;
  };
  const std::string lab = " --lab " + folder.lab.string(), scene = " '" + folder.scene.string() + "'";
  says("/nowhere/at/all.obj" + lab, "all.obj");
  says(folder.root.string() + lab, folder.root.string());
  says(scene + " --lab " + (folder.root / "assets").string(), "make lab");
  says(scene + lab + " --port 0", "--port");
  says(scene + lab + " --port 70000", "--port");
  const Viewing viewing(folder);
  says(scene + lab + " --port " + std::to_string(viewing.port()), "in use");
}

}  // namespace
