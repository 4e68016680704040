// What the programs for other systems have in common: they read the workload, and print
// rows as the other benches do.

#pragma once

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

struct Ray {
    double origin[3], direction[3];
};

struct Workload {
    const char *name;
    int depth;
    // Occupied cells of the finest grid, in the unit cube.
    std::vector<std::vector<double>> cells;
    // A thousand of all rays.
    std::vector<Ray> rays;
};

static double now() {
    timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

// Lines of numbers; # starts a comment.
static std::vector<std::vector<double>> read(const char *path) {
    std::ifstream file(path);
    if (!file) {
        std::fprintf(stderr, "there is no such file: %s\n", path);
        std::exit(1);
    }
    std::vector<std::vector<double>> lines;
    std::string line;
    while (std::getline(file, line)) {
        std::istringstream words(line.substr(0, line.find('#')));
        std::vector<double> numbers;
        std::string word;
        while (words >> word) numbers.push_back(std::strtod(word.c_str(), nullptr));
        if (!numbers.empty()) lines.push_back(numbers);
    }
    return lines;
}

// From the arguments NAME DEPTH CELLS RAYS.
static Workload load(int count, char **arguments) {
    if (count != 5) {
        std::fprintf(stderr, "give NAME DEPTH CELLS RAYS\n");
        std::exit(2);
    }
    Workload workload{arguments[1], std::atoi(arguments[2]), read(arguments[3]), {}};
    auto lines = read(arguments[4]);
    const std::size_t wanted = std::min<std::size_t>(1000, lines.size());
    for (std::size_t i = 0; i < wanted; ++i) {
        const auto &line = lines[i * lines.size() / wanted];
        workload.rays.push_back({{line[0], line[1], line[2]}, {line[3], line[4], line[5]}});
    }
    return workload;
}

// A row: boxes that `walk` meets on all rays, millions of rays a second, and in the best round.
// Times are those that the thread has computed.
template <class Walk>
static void measure(const char *query, const Workload &workload, Walk walk) {
    std::vector<double> times;
    long met = 0;
    for (int round = 0; round < 9; ++round) {
        double start = now();
        met = 0;
        for (const Ray &ray : workload.rays) met += walk(ray);
        times.push_back((now() - start) / double(workload.rays.size()));
    }
    std::sort(times.begin(), times.end());
    std::printf("%-5s %-10s %12ld boxes met  %9.3f %9.3f\n", query, workload.name, met,
                1e-6 / times[4], 1e-6 / times[0]);
}
