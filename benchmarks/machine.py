"""What the benchmarks say of the machine in their results."""

import platform


def machine():
    with open("/proc/cpuinfo") as file:
        names = [line.split(":")[1].strip() for line in file if line.startswith("model name")]
    return {"processor": names[0] if names else platform.processor(), "cores": len(names)}
