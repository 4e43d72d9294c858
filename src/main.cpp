// metamer: parses the command line and catches what the commands throw.
// gcc 12 sees a null string moved in CLI11's split() once it optimizes.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wnull-dereference"
#include <CLI/CLI.hpp>
#pragma GCC diagnostic pop
#include <exception>
#include <iostream>

#include "base/error.h"
#include "commands/commands.h"
#include "commands/usage.h"

int main(int argc, char** argv) {
    using metamer::Exit;
    CLI::App app("Shows what light does to color: lamps and materials as spectra, beside three numbers.",
                 "metamer");
    app.set_version_flag("--version", "metamer " METAMER_VERSION);
    app.require_subcommand(1);
    metamer::add_commands(app);
    try {
        app.parse(argc, argv);
        std::cout.flush();
        if (!std::cout)
            throw metamer::failure("write", "standard output", "it took no more");
        return static_cast<int>(Exit::ok);
    } catch (const CLI::Success& asked) { // --help, --version
        return app.exit(asked);
    } catch (const CLI::ParseError& error) {
        std::cerr << "metamer: cannot use the command line: " << metamer::usage_cause(app, error) << '\n';
        return static_cast<int>(Exit::bad_input);
    } catch (const metamer::Error& error) {
        std::cerr << "metamer: " << error.what() << '\n';
        return static_cast<int>(error.status());
    } catch (const std::exception& error) {
        std::cerr << "metamer: cannot go on: " << error.what() << '\n';
        return static_cast<int>(Exit::failure);
    }
}
