// OctoMap on the workload of our benches: rays through occupied cells.
//
//     g++ -O3 -march=native benches/peers/octomap.cpp -loctomap -loctomath -o octomap
//     octomap NAME DEPTH CELLS RAYS
//
// Prints two rows as the other benches do: `enum` lists the cells of the finest grid on a
// ray inside the unit cube and looks each of them up; `first` is OctoMap's own castRay
// through unknown space, from where the ray enters the cube. Times are those that the thread has computed.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <octomap/octomap.h>
#include <sstream>
#include <vector>

using octomap::OcTree;
using octomap::point3d;

struct Ray {
    double origin[3], direction[3];
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

// Where the ray is in the unit cube: from and to; false if nowhere.
static bool clip(const Ray &ray, double &from, double &to) {
    from = 0.0, to = 1e9;
    for (int e = 0; e < 3; ++e) {
        double o = ray.origin[e], d = ray.direction[e];
        if (d == 0.0) {
            if (o < 0.0 || o >= 1.0) return false;
            continue;
        }
        double a = -o / d, b = (1.0 - o) / d;
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    return from < to;
}

static point3d at(const Ray &ray, double t) {
    return point3d(float(ray.origin[0] + t * ray.direction[0]),
                   float(ray.origin[1] + t * ray.direction[1]),
                   float(ray.origin[2] + t * ray.direction[2]));
}

static long enumerate(const OcTree &tree, const Ray &ray, octomap::KeyRay &keys) {
    double from, to;
    if (!clip(ray, from, to) || !tree.computeRayKeys(at(ray, from), at(ray, to), keys)) return 0;
    long full = 0;
    for (const auto &key : keys) full += tree.search(key) != nullptr;
    return full;
}

static long first(const OcTree &tree, const Ray &ray) {
    double from, to;
    if (!clip(ray, from, to)) return 0;
    point3d direction(float(ray.direction[0]), float(ray.direction[1]), float(ray.direction[2]));
    point3d end;
    return tree.castRay(at(ray, from), direction, end, true, 2.0);
}

template <class Walk>
static void measure(const char *query, const char *name, const std::vector<Ray> &rays, Walk walk) {
    std::vector<double> times;
    long met = 0;
    for (int round = 0; round < 9; ++round) {
        double start = now();
        met = 0;
        for (const Ray &ray : rays) met += walk(ray);
        times.push_back((now() - start) / double(rays.size()));
    }
    std::sort(times.begin(), times.end());
    std::printf("%-5s %-10s %12ld boxes met  %9.3f %9.3f\n", query, name, met,
                1e-6 / times[4], 1e-6 / times[0]);
}

int main(int count, char **arguments) {
    if (count != 5) {
        std::fprintf(stderr, "give NAME DEPTH CELLS RAYS\n");
        return 2;
    }
    OcTree tree(std::pow(2.0, -std::atoi(arguments[2])));
    const unsigned middle = 32768;
    for (const auto &cell : read(arguments[3])) {
        octomap::OcTreeKey key(middle + unsigned(cell[0]), middle + unsigned(cell[1]),
                               middle + unsigned(cell[2]));
        tree.setNodeValue(key, 2.0f, true);
    }
    tree.updateInnerOccupancy();
    std::vector<Ray> rays;
    auto lines = read(arguments[4]);
    const std::size_t wanted = std::min<std::size_t>(1000, lines.size());
    for (std::size_t i = 0; i < wanted; ++i) {
        const auto &line = lines[i * lines.size() / wanted];
        rays.push_back({{line[0], line[1], line[2]}, {line[3], line[4], line[5]}});
    }
    octomap::KeyRay keys;
    measure("enum", arguments[1], rays, [&](const Ray &ray) { return enumerate(tree, ray, keys); });
    measure("first", arguments[1], rays, [&](const Ray &ray) { return first(tree, ray); });
}
