#include "commands/usage.h"

#include <string_view>
#include <vector>

#include "base/names.h"

namespace metamer {

namespace {

std::vector<std::string> command_names(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::App* sub : command.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(sub->get_name());
    return names;
}

std::vector<std::string> option_names(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options())
        for (const std::string& name : option->get_lnames())
            names.push_back("--" + name);
    return names;
}

// `metamer atlas build`
std::string full_name(const CLI::App& command) {
    return command.get_parent() ? full_name(*command.get_parent()) + " " + command.get_name()
                                : command.get_name();
}

// The commands that were asked for, from the program inwards.
std::vector<const CLI::App*> asked_for(const CLI::App& app) {
    std::vector<const CLI::App*> chain{&app};
    while (!chain.back()->get_subcommands().empty())
        chain.push_back(chain.back()->get_subcommands().back());
    return chain;
}

std::string unknown_word(const CLI::App& command, const std::string& word) {
    if (word.starts_with('-') && word.size() > 1) {
        const std::string option = word.substr(0, word.find('='));
        return full_name(command) + " has no option " + option + did_you_mean(option, option_names(command));
    }
    const auto commands = command_names(command);
    if (!commands.empty() && command.get_subcommands().empty())
        return full_name(command) + " has no command \"" + word + "\"" + did_you_mean(word, commands);
    return "\"" + word + "\" is one argument too many";
}

std::string missing_command(const CLI::App& command) {
    std::string text;
    for (const std::string& name : command_names(command))
        text += (text.empty() ? "a command is missing, one of " : ", ") + name;
    return text;
}

// CLI11's `--output: 1 required F.png missing`.
std::string other_cause(const CLI::ParseError& error) {
    const std::string_view text = error.what();
    if (error.get_name() == "ArgumentMismatch" && text.ends_with(" missing"))
        return std::string(text.substr(0, text.find(':'))) + " needs a value";
    return std::string(text);
}

} // namespace

std::string usage_cause(const CLI::App& app, const CLI::ParseError& error) {
    const auto chain = asked_for(app);
    const CLI::App* about = chain.back();
    std::string cause;
    for (const CLI::App* command : chain)
        if (const auto words = command->remaining(); cause.empty() && !words.empty()) {
            about = command;
            cause = unknown_word(*command, words.front());
        }
    if (cause.empty())
        cause = about->get_subcommands().empty() && !command_names(*about).empty() ? missing_command(*about)
                                                                                   : other_cause(error);
    return cause.ends_with('?') ? cause : cause + "; see " + full_name(*about) + " --help";
}

} // namespace metamer
