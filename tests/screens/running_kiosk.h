// `metamer run` as people start it: a process of its own, watched through what it tells of its screen.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <sys/types.h>
#include <vector>

namespace metamer::test {

using Json = nlohmann::json;

class RunningKiosk {
public:
    /// Starts it in this folder with these arguments and `--describe`, and these variables besides the
    /// environment. Does not wait.
    RunningKiosk(std::filesystem::path folder, const std::vector<std::string>& arguments,
                 const std::map<std::string, std::string>& environment = {});
    RunningKiosk(const RunningKiosk&) = delete;
    RunningKiosk& operator=(const RunningKiosk&) = delete;
    /// Ends it by force where it still runs.
    ~RunningKiosk();

    /// What it tells of its screen, once `is` holds of that. Throws std::runtime_error with `what`, the last
    /// it told and its log where that is not so after a long time, or the process ended.
    Json await(const std::string& what, const std::function<bool(const Json&)>& is);
    /// The same without a condition: once it tells anything.
    Json told() {
        return await("anything on the screen", [](const Json&) { return true; });
    }

    /// The same for its log: waits until this stands there.
    void await_log(const std::string& part);

    void send(int signal) const;
    /// Sends it and waits for the end, a long time at most: its exit status, 128 + signal when one ended it.
    int end_by(int signal);

    std::string log() const;
    pid_t id() const { return process_; }

private:
    bool ended();

    std::filesystem::path folder_;
    pid_t process_ = -1;
    int status_ = -1; ///< once it ended
};

/// The widget of this part in what was told; null where there is none.
Json widget(const Json& told, const std::string& part, int index = 0);

} // namespace metamer::test
