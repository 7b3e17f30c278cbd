"""Where the labels of a picture's points go: beside their points, and where there is room on nobody else."""

GAP = 5  # between a point and its label
MARKER = 3.5  # from a point's middle to its edge


def overlap(a, b):
    width = min(a[2], b[2]) - max(a[0], b[0])
    height = min(a[3], b[3]) - max(a[1], b[1])
    return max(width, 0) * max(height, 0)


def places_beside(x, y, width, height):
    """From the one that reads best: right, left, above, below, then in growing steps up and down."""
    for side in (x + GAP, x - GAP - width):
        yield side, y - height / 2
    for row in (y + GAP, y - GAP - height):
        yield x - width / 2, row
    for step in range(1, 9):
        for row in (y + step * height * 0.5, y - step * height * 0.5):
            for side in (x + GAP, x - GAP - width):
                yield side, row - height / 2


def label_places(points, sizes, area, taken=()):
    """The lower left corner of each point's label, in the points' units. `sizes` holds each label's width and height;
    `area` and the boxes `taken` are (left, bottom, right, top). Labels are placed in turn, each where it covers the least
    of points, labels and boxes, and lies outside the area with the least of itself; of equal places the first."""
    boxes = list(taken) + [(x - MARKER, y - MARKER, x + MARKER, y + MARKER) for x, y in points]
    found = []
    for (x, y), (width, height) in zip(points, sizes):
        def covered(place):
            box = (*place, place[0] + width, place[1] + height)
            return sum(overlap(box, other) for other in boxes) + 3 * (width * height - overlap(box, area))

        place = min(places_beside(x, y, width, height), key=covered)  # the first of those that cover the least
        boxes.append((*place, place[0] + width, place[1] + height))
        found.append(place)
    return found
