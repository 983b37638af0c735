#include "model/characterise/process_tree.hpp"

#include <signal.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace mixcmp::model {
namespace {

namespace fs = std::filesystem;

/// The parent as /proc/PID/stat tells it, behind the name in brackets and the state; 0: no such
/// process any more.
pid_t parent_of(const fs::path& process) {
  std::string line;
  std::ifstream stream(process / "stat");
  std::getline(stream, line);
  std::istringstream rest(line.substr(std::min(line.rfind(')') + 1, line.size())));
  char state = 0;
  pid_t parent = 0;
  rest >> state >> parent;
  return parent;
}

std::vector<pid_t> children_of(pid_t parent) {
  std::vector<pid_t> children;
  std::error_code failed;
  for (fs::directory_iterator entry("/proc", failed), end; !failed && entry != end;
       entry.increment(failed)) {
    const std::string name = entry->path().filename().string();
    pid_t process = 0;
    std::from_chars(name.data(), name.data() + name.size(), process);
    if (process > 0 && parent_of(entry->path()) == parent) children.push_back(process);
  }
  return children;
}

}  // namespace

void end_process_tree(pid_t root) {
  std::vector<pid_t> tree = {root};
  for (std::size_t k = 0; k < tree.size(); ++k) {
    // What is stopped starts nothing more.
    kill(tree[k], SIGSTOP);
    for (const pid_t child : children_of(tree[k])) tree.push_back(child);
  }
  for (const pid_t process : tree) kill(process, SIGKILL);
}

}  // namespace mixcmp::model
