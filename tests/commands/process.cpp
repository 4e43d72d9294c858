#include "commands/process.h"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <memory>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace metamer::test {

namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

// An unnamed file: unlike a pipe it never fills up while nobody reads.
File temporary_file() {
    File file(std::tmpfile(), std::fclose);
    if (!file)
        throw std::runtime_error("no temporary file to be had");
    return file;
}

std::string text_of(std::FILE* file) {
    std::rewind(file);
    std::string text;
    char block[4096];
    while (const std::size_t count = std::fread(block, 1, sizeof block, file))
        text.append(block, count);
    return text;
}

// The child's last steps before the program; 127 is what a shell says when one fails.
[[noreturn]] void become(const std::string& program, std::vector<char*> arguments, const World& world,
                         int out, int err) {
    const int nothing = ::open("/dev/null", O_RDONLY);
    if (!world.standard_output.empty())
        out = ::open(world.standard_output.c_str(), O_WRONLY);
    if (::dup2(nothing, 0) < 0 || ::dup2(out, 1) < 0 || ::dup2(err, 2) < 0 ||
        ::chdir(world.folder.c_str()) != 0)
        ::_exit(127);
    for (const auto& [name, value] : world.environment)
        ::setenv(name.c_str(), value.c_str(), 1);
    if (world.most_file_bytes) {
        const rlimit limit{*world.most_file_bytes, *world.most_file_bytes};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        std::signal(SIGXFSZ, SIG_IGN); // write() then fails, as on a full disk
    }
    ::execv(program.c_str(), arguments.data());
    ::_exit(127);
}

} // namespace

Outcome run_program(const std::string& program, const std::vector<std::string>& arguments,
                    const World& world) {
    const File out = temporary_file(), err = temporary_file();
    std::vector<char*> pointers{const_cast<char*>(program.c_str())};
    for (const std::string& argument : arguments)
        pointers.push_back(const_cast<char*>(argument.c_str()));
    pointers.push_back(nullptr);

    const pid_t child = ::fork();
    if (child == 0)
        become(program, pointers, world, ::fileno(out.get()), ::fileno(err.get()));
    int status = 0;
    if (child < 0 || ::waitpid(child, &status, 0) != child)
        throw std::runtime_error("no process to be had for " + program);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), text_of(out.get()),
            text_of(err.get())};
}

} // namespace metamer::test
