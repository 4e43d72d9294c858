// systemd's part in sd_notify(3): a datagram socket, to be named in NOTIFY_SOCKET.
#pragma once

#include <filesystem>
#include <poll.h>
#include <stdexcept>
#include <string>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace metamer::test {

class NotifySocket {
public:
    NotifySocket() {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        path_.copy(address.sun_path, sizeof address.sun_path - 1);
        if (bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
            throw std::runtime_error("cannot listen at " + path_);
    }
    NotifySocket(const NotifySocket&) = delete;
    NotifySocket& operator=(const NotifySocket&) = delete;
    ~NotifySocket() {
        close(socket_);
        std::filesystem::remove(path_);
    }

    const std::string& path() const { return path_; }

    /// The next datagram, waited for so long; empty where there is none.
    std::string heard(int most_ms = 0) const {
        pollfd ready{socket_, POLLIN, 0};
        char bytes[4096];
        const auto size =
            poll(&ready, 1, most_ms) == 1 ? recv(socket_, bytes, sizeof bytes, MSG_DONTWAIT) : -1;
        return size < 0 ? "" : std::string(bytes, static_cast<std::size_t>(size));
    }

private:
    std::string path_ =
        (std::filesystem::temp_directory_path() / ("metamer-notify-" + std::to_string(getpid()))).string();
    int socket_ = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
};

} // namespace metamer::test
