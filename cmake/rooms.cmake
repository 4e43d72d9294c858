# The house: a room is a static library `metamer_ROOM` made of src/ROOM, a test room is one test program.

add_library(metamer_flags INTERFACE)
target_compile_options(metamer_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wdouble-promotion
                                               -Wnon-virtual-dtor -Woverloaded-virtual -Wnull-dereference)
# gcc 12 sees overlaps in every `"x" + std::string` once it optimizes (GCC bug 105651).
target_compile_options(metamer_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
# Every round-off of the twins is theirs: no fused multiply-add behind our backs.
target_compile_options(metamer_flags INTERFACE -ffp-contract=off)
if(METAMER_WERROR)
    target_compile_options(metamer_flags INTERFACE -Werror)
endif()
if(METAMER_SANITIZE)
    set(sanitizers -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_compile_options(metamer_flags INTERFACE ${sanitizers})
    target_link_options(metamer_flags INTERFACE ${sanitizers})
endif()
if(METAMER_FUZZ)
    target_compile_options(metamer_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()

# metamer_room(NAME SOURCES file... [LINKS target...])
function(metamer_room name)
    cmake_parse_arguments(ROOM "" "" "SOURCES;LINKS" ${ARGN})
    add_library(metamer_${name} STATIC ${ROOM_SOURCES})
    target_include_directories(metamer_${name} PUBLIC ${PROJECT_SOURCE_DIR}/src)
    target_link_libraries(metamer_${name} PUBLIC ${ROOM_LINKS} PRIVATE metamer_flags)
endfunction()

# metamer_test(NAME SOURCES file... LINKS target...)   one program test_NAME, registered test by test with ctest
function(metamer_test name)
    cmake_parse_arguments(TEST "" "" "SOURCES;LINKS" ${ARGN})
    add_executable(test_${name} ${TEST_SOURCES})
    target_include_directories(test_${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
    target_compile_definitions(test_${name} PRIVATE METAMER_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    target_link_libraries(test_${name} PRIVATE ${TEST_LINKS} metamer_flags GTest::gmock GTest::gtest_main)
    include(GoogleTest)
    # A parameter's value in the name may be an address: names without values stay what they are.
    gtest_discover_tests(test_${name} NO_PRETTY_VALUES DISCOVERY_TIMEOUT 60 WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
                         TEST_PREFIX ${name}.)
endfunction()

# metamer_test_again(PROGRAM NAME VARIABLE=VALUE FILTER)   tests of test_PROGRAM once more under another environment;
#   several variables are parted by semicolons
function(metamer_test_again program name environment filter)
    add_test(NAME ${program}.again-${name} COMMAND test_${program} --gtest_filter=${filter}
             WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
    set_tests_properties(${program}.again-${name} PROPERTIES ENVIRONMENT "${environment}")
endfunction()

# metamer_embed(TARGET NAMESPACE file...)
#   adds to TARGET one generated source that holds the files as text, looked up by name:
#   `std::string_view NAMESPACE::embedded(std::string_view file_name)`, empty when there is no such file.
function(metamer_embed target namespace)
    set(generated ${CMAKE_CURRENT_BINARY_DIR}/${namespace}_embedded.cpp)
    add_custom_command(
        OUTPUT ${generated}
        COMMAND ${CMAKE_COMMAND} -DOUTPUT=${generated} -DNAMESPACE=${namespace} "-DFILES=${ARGN}"
                -P ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
        DEPENDS ${ARGN} ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
        VERBATIM)
    target_sources(${target} PRIVATE ${generated})
endfunction()
