#include "screens/running_kiosk.h"

#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace metamer::test {

namespace {

constexpr const char* kDescription = "screen.json";
constexpr const char* kLog = "log.txt";
constexpr auto kLong = std::chrono::seconds(40);
constexpr auto kGlance = std::chrono::milliseconds(5);

std::string text_of(const std::filesystem::path& path) {
    std::ifstream in(path);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

} // namespace

RunningKiosk::RunningKiosk(std::filesystem::path folder, const std::vector<std::string>& arguments,
                           const std::map<std::string, std::string>& environment)
    : folder_(std::move(folder)) {
    std::vector<std::string> words{METAMER_PROGRAM, "run", "--describe", kDescription};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words)
        pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const std::string log = folder_ / kLog;
    std::filesystem::remove(folder_ / kDescription);
    process_ = fork();
    if (process_ < 0)
        throw std::runtime_error("no process to be had");
    if (process_ > 0)
        return;
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const int err = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    for (const auto& [name, value] : environment)
        setenv(name.c_str(), value.c_str(), 1);
    if (chdir(folder_.c_str()) == 0 && dup2(err, 1) >= 0 && dup2(err, 2) >= 0)
        execv(pointers[0], pointers.data());
    _exit(127);
}

RunningKiosk::~RunningKiosk() {
    if (ended())
        return;
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
}

bool RunningKiosk::ended() {
    int status = 0;
    if (status_ < 0 && waitpid(process_, &status, WNOHANG) == process_)
        status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return status_ >= 0;
}

Json RunningKiosk::await(const std::string& what, const std::function<bool(const Json&)>& is) {
    const auto until = std::chrono::steady_clock::now() + kLong;
    std::string text;
    do {
        text = text_of(folder_ / kDescription);
        const Json told = Json::parse(text, nullptr, false);
        if (!told.is_discarded() && is(told))
            return told;
        std::this_thread::sleep_for(kGlance);
    } while (!ended() && std::chrono::steady_clock::now() < until);
    throw std::runtime_error("never came: " + what + "\n" + text + log());
}

void RunningKiosk::await_log(const std::string& part) {
    const auto until = std::chrono::steady_clock::now() + kLong;
    while (log().find(part) == std::string::npos) {
        if (ended() || std::chrono::steady_clock::now() >= until)
            throw std::runtime_error("never came: " + part + "\n" + log());
        std::this_thread::sleep_for(kGlance);
    }
}

void RunningKiosk::send(int signal) const {
    kill(process_, signal);
}

int RunningKiosk::end_by(int signal) {
    send(signal);
    for (const auto until = std::chrono::steady_clock::now() + kLong;
         !ended() && std::chrono::steady_clock::now() < until;)
        std::this_thread::sleep_for(kGlance);
    return status_;
}

std::string RunningKiosk::log() const {
    return text_of(folder_ / kLog);
}

Json widget(const Json& told, const std::string& part, int index) {
    for (const Json& one : told.at("widgets"))
        if (one.at("part") == part && one.at("index") == index)
            return one;
    return nullptr;
}

} // namespace metamer::test
