// SPDX-License-Identifier: GPL-3.0-or-later
// Items decided by several processes. Not by threads: GiNaC counts references without locks and numbers its symbols
// globally. A worker takes the next number from a pipe that all of them read, and answers on a pipe of its own with a
// line of JSON.
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "twoscale/reports/audit.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::reports::audit {

namespace {

using Json = nlohmann::ordered_json;
using Number = std::uint32_t;  // of an item; four bytes are written to and read from a pipe at once

struct Pipe {
  int read = -1, write = -1;
};

Pipe make_pipe() {
  int ends[2];
  if (pipe(ends) != 0) throw Error(Error::Kind::io, "no pipe to a worker", std::to_string(errno));
  return {ends[0], ends[1]};
}

// All of it, whatever interrupts; false when nobody reads any more.
bool write_all(int file, const char* data, std::size_t size) {
  while (size > 0) {
    const ssize_t n = write(file, data, size);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    data += n;
    size -= static_cast<std::size_t>(n);
  }
  return true;
}

std::string answer(const Item& item, Number number) {
  Json j{{"number", number}};
  try {
    j["result"] = result_json(audit(item));
  } catch (const Error& e) {
    j["error"] = {{"kind", static_cast<int>(e.kind)}, {"what", e.what()}, {"offending", e.offending}};
  } catch (const std::exception& e) {
    j["failure"] = e.what();
  }
  return j.dump() + "\n";
}

Error error_from(const Json& j) {
  const std::string offending = j["offending"];
  std::string message = j["what"];
  if (!offending.empty()) message.resize(message.size() - offending.size() - 2);  // what() is "message: offending"
  return Error(static_cast<Error::Kind>(j["kind"].get<int>()), message, offending);
}

// Never returns: a worker leaves without the destructors and buffers that are its parent's.
[[noreturn]] void work(const std::vector<Item>& items, int tasks, int answers) {
  Number number = 0;
  while (read(tasks, &number, sizeof number) == static_cast<ssize_t>(sizeof number)) {
    const std::string line = answer(items[number], number);
    if (!write_all(answers, line.data(), line.size())) break;
  }
  _exit(0);
}

// A worker that has died is seen when its pipe ends, not by a signal.
class NoBrokenPipes {
 public:
  NoBrokenPipes() : before_(std::signal(SIGPIPE, SIG_IGN)) {}
  ~NoBrokenPipes() { std::signal(SIGPIPE, before_); }
  NoBrokenPipes(const NoBrokenPipes&) = delete;
  NoBrokenPipes& operator=(const NoBrokenPipes&) = delete;

 private:
  void (*before_)(int);
};

class Workers {
 public:
  Workers(const std::vector<Item>& items, int count) {
    tasks_ = make_pipe();
    for (int i = 0; i < count; ++i) {
      const Pipe answers = make_pipe();
      const pid_t child = fork();
      if (child < 0) throw Error(Error::Kind::io, "no process for a worker", std::to_string(errno));
      if (child == 0) {
        close(tasks_.write);
        close(answers.read);
        for (const auto& w : workers_) close(w.file);
        work(items, tasks_.read, answers.write);
      }
      close(answers.write);
      workers_.push_back({child, answers.read, {}});
    }
    close(tasks_.read);
    tasks_.read = -1;
  }
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;
  ~Workers() {
    finish_tasks();
    if (tasks_.read >= 0) close(tasks_.read);
    for (const Worker& w : workers_) {
      close(w.file);
      if (!done_) kill(w.process, SIGTERM);
      waitpid(w.process, nullptr, 0);
    }
  }

  // No more items: a worker that finds none ends.
  void finish_tasks() {
    if (tasks_.write >= 0) close(tasks_.write);
    tasks_.write = -1;
  }

  bool give(Number number) { return write_all(tasks_.write, reinterpret_cast<const char*>(&number), sizeof number); }

  // The next line of an answer; empty when all workers have ended.
  std::string next() {
    while (true) {
      std::vector<pollfd> polled;
      for (Worker& w : workers_) {
        if (const auto end = w.text.find('\n'); end != std::string::npos) {
          std::string line = w.text.substr(0, end);
          w.text.erase(0, end + 1);
          return line;
        }
        if (!w.ended) polled.push_back({w.file, POLLIN, 0});
      }
      if (polled.empty()) {
        done_ = true;
        return {};
      }
      if (poll(polled.data(), polled.size(), -1) < 0 && errno != EINTR)
        throw Error(Error::Kind::io, "workers cannot be heard", std::to_string(errno));
      for (const pollfd& p : polled)
        if (p.revents != 0) receive(p.fd);
    }
  }

 private:
  struct Worker {
    pid_t process;
    int file;
    std::string text;
    bool ended = false;
  };

  void receive(int file) {
    std::array<char, 65536> bytes{};
    const ssize_t n = read(file, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) return;
    for (Worker& w : workers_) {
      if (w.file != file) continue;
      if (n > 0)
        w.text.append(bytes.data(), static_cast<std::size_t>(n));
      else
        w.ended = true;
    }
  }

  Pipe tasks_;
  std::vector<Worker> workers_;
  bool done_ = false;
};

}  // namespace

nlohmann::ordered_json result_json(const Result& r) {
  return {
      {"verdict", to_string(r.verdict)}, {"evidence", r.evidence}, {"correction", r.correction}, {"proof", r.proof}};
}

std::optional<Result> result_from(const nlohmann::ordered_json& j) {
  if (!j.is_object()) return std::nullopt;
  for (const char* key : {"verdict", "evidence", "correction", "proof"})
    if (!j.contains(key) || !j[key].is_string()) return std::nullopt;
  for (const auto v : {Verdict::holds, Verdict::fails, Verdict::corrected, Verdict::undecided})
    if (to_string(v) == j["verdict"].get<std::string>())
      return Result{v, j["evidence"].get<std::string>(), j["correction"].get<std::string>(),
                    j["proof"].get<std::string>()};
  return std::nullopt;
}

void run(const std::vector<Item>& items, int processes,
         const std::function<void(std::size_t, const Result&)>& decided) {
  const int count = std::min<int>(processes, static_cast<int>(items.size()));
  if (count <= 1) {
    for (std::size_t i = 0; i < items.size(); ++i) decided(i, audit(items[i]));
    return;
  }
  const NoBrokenPipes guard;
  std::map<std::size_t, std::exception_ptr> errors;
  std::size_t received = 0;
  {
    Workers workers(items, count);
    // As many items are on their way as there are workers and one more, so that the pipe never fills.
    std::size_t given = 0;
    const auto give = [&] {
      if (given < items.size() && workers.give(static_cast<Number>(given))) ++given;
      if (given == items.size()) workers.finish_tasks();
    };
    for (int i = 0; i <= count; ++i) give();
    for (std::string line = workers.next(); !line.empty(); line = workers.next()) {
      const Json j = Json::parse(line);
      const auto index = j["number"].get<std::size_t>();
      ++received;
      give();
      if (const auto result = j.contains("result") ? result_from(j["result"]) : std::nullopt)
        decided(index, *result);
      else if (j.contains("error"))
        errors[index] = std::make_exception_ptr(error_from(j["error"]));
      else
        errors[index] = std::make_exception_ptr(std::runtime_error(j.value("failure", "a worker answered nonsense")));
    }
  }
  if (!errors.empty()) std::rethrow_exception(errors.begin()->second);
  if (received < items.size()) throw std::runtime_error("a worker of the audit has died");
}

}  // namespace twoscale::reports::audit
