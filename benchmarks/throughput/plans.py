"""How many steps are run: enough for a steady figure, few enough for five rounds."""

from dataclasses import dataclass

# (case, grains): steps of relaxation, steps that count, the same of the peers. Where the state changes while it is
# measured all programs take the same number.
STEPS = {
    ("settled", 15600): (500, 12000, 2500),
    ("settled", 156000): (100, 1000, 200),
    ("settled", 1000000): (20, 100, 25),
    ("moving", 15600): (200, 3000, 3000),
    ("moving", 156000): (50, 400, 400),
    ("moving", 1000000): (20, 60, 60),
    ("discharge_mini", "segment"): (200, 5000, 5000),
    ("discharge_mini", "whole"): (50000, 220000, 220000),
}


@dataclass
class Plan:
    relax: int
    ours: int
    theirs: int
    whole: bool  # from the start to the end: nothing is subtracted

    def steps(self, code):
        return self.ours if code == "repose" else self.theirs

    @staticmethod
    def of(args):
        """The table's entry, or that of the next size below; --relax and --steps replace its figures."""
        if args.case == "discharge_mini":
            relax, ours, theirs = STEPS[args.case, "segment" if args.segment else "whole"]
        else:
            sizes = [size for case, size in STEPS if case == args.case and size <= args.size]
            relax, ours, theirs = STEPS[args.case, max(sizes, default=15600)]
        steps = (args.steps, args.steps) if args.steps else (ours, theirs)
        return Plan(args.relax or relax, *steps, args.case == "discharge_mini" and not args.segment)
