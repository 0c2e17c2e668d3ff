# SPDX-License-Identifier: GPL-3.0-or-later
"""A plain invariant polytope algorithm in floating point (Guglielmi, Protasov 2013): a reference for cost, no proof.

Candidates are all words up to a length, points are compared by linear programmes (SciPy, HiGHS), all with a tolerance.
The common invariant subspaces are not looked for: the matrices come as diagonal blocks. Real leading eigenvalues only.
"""

import itertools

import numpy
import scipy.optimize

TOLERANCE = 1e-8


def products(matrices, most):
    """(word, product) for all words of one length after the other, as long as there are at most so many."""
    level = [((s,), a) for s, a in enumerate(matrices)]
    while level and len(level) <= most:
        yield from level
        level = [((*w, s), a @ p) for (w, p), (s, a) in itertools.product(level, enumerate(matrices))]


def candidates(matrices, most):
    """The largest rho(A_w)^(1/|w|), and the words that attain it, one a cycle and none a power."""
    best, words = 0.0, []
    for word, product in products(matrices, most):
        value = numpy.abs(numpy.linalg.eigvals(product)).max() ** (1 / len(word))
        if value > best * (1 + 1e-9):
            best, words = value, [word]
        elif value > best * (1 - 1e-9):
            words.append(word)
    kept = []
    for word in words:
        rotations = {word[i:] + word[:i] for i in range(len(word))}
        if not any(len(word) % len(w) == 0 and w * (len(word) // len(w)) in rotations for w in kept):
            kept.append(word)
    return best, kept


def roots(matrices, word):
    """The leading eigenvector of A_w and its images along the word; None if the eigenvalue is not real."""
    product = numpy.eye(len(matrices[0]))
    for s in word:
        product = matrices[s] @ product
    values, vectors = numpy.linalg.eig(product)
    first = numpy.abs(values).argmax()
    if abs(values[first].imag) > TOLERANCE * abs(values[first]):
        return None
    radius = abs(values[first]) ** (1 / len(word))
    v = vectors[:, first].real
    cycle = [v / numpy.linalg.norm(v)]
    for s in word[:-1]:
        cycle.append(matrices[s] @ cycle[-1] / radius)
    return cycle


def inside(vertices, point):
    """Is the point in the symmetric convex hull?"""
    columns = numpy.array(vertices).T
    done = scipy.optimize.linprog(numpy.ones(2 * columns.shape[1]), A_eq=numpy.hstack([columns, -columns]), b_eq=point,
                                  method="highs")
    return done.status == 0 and done.fun <= 1 + TOLERANCE


def closes(matrices, radius, words, most):
    """The number of vertices of a polytope that A_s/radius map into itself; None if there are more than so many."""
    vertices = []
    for word in words:
        cycle = roots(matrices, word)
        if cycle is None:
            return None
        vertices += cycle
    fresh = list(vertices)
    while fresh:
        images = [a @ v / radius for v in fresh for a in matrices]
        fresh = []
        for image in images:
            if not inside(vertices, image):
                vertices.append(image)
                fresh.append(image)
        if len(vertices) > most:
            return None
    return len(vertices)


def search(blocks, most=600):
    """candidates() of each diagonal block."""
    return [candidates(matrices, most) for matrices in blocks]


def joint_spectral_radius(blocks, found, most=5000):
    """(radius, vertices of all polytopes) from what search() found; None if a polytope does not close."""
    radius = max(best for best, _ in found)
    count = 0
    for matrices, (best, cycles) in zip(blocks, found):
        if len(matrices[0]) == 1 or best == 0:
            continue
        size = closes(matrices, radius, cycles, most)
        if size is None:
            return None
        count += size
    return radius, count
