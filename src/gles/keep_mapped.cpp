#include "gles/keep_mapped.h"

#include <dlfcn.h>
#include <link.h>
#include <string>
#include <vector>

namespace metamer {

namespace {
int remember_name(dl_phdr_info* info, std::size_t, void* names) {
    if (info->dlpi_name != nullptr && *info->dlpi_name != '\0')
        static_cast<std::vector<std::string>*>(names)->push_back(info->dlpi_name);
    return 0;
}
} // namespace

void keep_libraries_mapped() {
    // Names first: dl_iterate_phdr holds the loader's lock while it calls back.
    std::vector<std::string> names;
    dl_iterate_phdr(remember_name, &names);
    for (const std::string& name : names)
        if (void* library = dlopen(name.c_str(), RTLD_LAZY | RTLD_NOLOAD | RTLD_NODELETE))
            dlclose(library);
}

} // namespace metamer
