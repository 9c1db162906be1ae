"""Kernel machines as arrays: decision values of several at once, by two products of matrices."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from tracking.arrays import Floats


@dataclass(frozen=True, slots=True, eq=False)
class Machine:
    """One trained machine: sum of coefficient x kernel(support, x) + intercept.

    Attributes:
        support: (m, d) support vectors. coefficient: (m,).
        gamma: of the kernel exp(-gamma |support - x|^2); 0: the kernel is support . x.
    """

    support: Floats
    coefficient: Floats
    intercept: float
    gamma: float


@dataclass(frozen=True, slots=True, eq=False)
class Machines:
    """Several machines over the same numbers, in one go.

    Attributes:
        each: the machines, k.
    """

    each: tuple[Machine, ...]
    _inner: Floats = field(init=False, repr=False)
    _outer: Floats = field(init=False, repr=False)
    _linear: Floats = field(init=False, repr=False)
    _intercept: Floats = field(init=False, repr=False)

    def __post_init__(self) -> None:
        """Lay the support vectors out so that two products of matrices give every decision.

        -gamma |s - x|^2 is the product of [x, |x|^2, 1] with [2 gamma s, -gamma, -gamma |s|^2].
        """
        curved = [machine for machine in self.each if machine.gamma > 0]
        numbers = self.each[0].support.shape[1]
        inner = [_inner_rows(machine) for machine in curved]
        rows = sum(map(len, inner))
        outer, linear = np.zeros((rows, len(self.each))), np.zeros((numbers, len(self.each)))
        start = 0
        for at, machine in enumerate(self.each):
            if machine.gamma > 0:
                stop = start + len(machine.support)
                outer[start:stop, at], start = machine.coefficient, stop
            else:
                linear[:, at] = machine.coefficient @ machine.support
        whole = np.concatenate([np.zeros((0, numbers + 2)), *inner])
        object.__setattr__(self, "_inner", np.ascontiguousarray(whole.T))
        object.__setattr__(self, "_outer", outer)
        object.__setattr__(self, "_linear", linear)
        object.__setattr__(
            self, "_intercept", np.array([machine.intercept for machine in self.each])
        )

    def decide(self, values: Floats) -> Floats:
        """Decision values (n, k) of rows (n, d); NaN where a row has one."""
        squared = np.einsum("nd,nd->n", values, values)[:, None]
        row = np.concatenate((values, squared, np.ones_like(squared)), axis=1)
        kernel = row @ self._inner
        np.exp(kernel, out=kernel)
        decided: Floats = kernel @ self._outer + values @ self._linear + self._intercept
        return decided


def _inner_rows(machine: Machine) -> Floats:
    gamma, support = machine.gamma, machine.support
    squared = np.einsum("md,md->m", support, support)[:, None]
    last = np.full_like(squared, -gamma)
    return np.concatenate((2 * gamma * support, last, -gamma * squared), axis=1)
