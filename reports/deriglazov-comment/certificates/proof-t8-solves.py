# -*- coding: utf-8 -*-
# deriglazov-comment / t8-solves: Uniform rotation with the rate m₃/I₃ solves t7.1 and starts at R = 1, for all moments and either sign of m₃.
#
# Given: the definitions, the assumptions and momentum.
#
# Each equation below is proved by an identity of polynomials, d*N = q1*p1 + q2*p2 + ...
# N is the difference of its sides, without its denominator. Every p is 0 where what is given holds,
# and d is not 0 there, where the formulas have a value. So N is 0 there, and the equation holds.
# The program computes N from the sides and every p from what is given, as they are written below, and prints
# one 0 for each equation. It needs Python and SymPy. Whoever changes a side gets another number, and exit code 1.
# A function is replaced by polynomials in variables that stand for cosines, sines, exponentials, roots; that
# each replacement is right is looked up at random numbers, to 40 digits.

import ast
import random
import sys

import mpmath
from sympy import QQ, ring


def check(names, left, right, relations, d, definitions={}, functions={}, variables={}):
    """Prints d*N - (q1*p1 + q2*p2 + ...), which is 0, with N and p1, p2, ... computed from what stands above.

    An expression is a quotient of polynomials, top and under: sums get a common denominator, nothing is cancelled.
    N is the top of left - right, with whole coefficients; p is the same of the two sides of a relation.
    """
    space, *generators = ring(names or ["unused"], QQ)
    known = {name: (generator, space.one) for name, generator in zip(names, generators)}
    plain = {ast.unparse(ast.parse(call, mode="eval")): image for call, image in functions.items()}
    found = {}

    def quotient(text):
        if text not in found:
            found[text] = walk(ast.parse(text, mode="eval").body)
        return found[text]

    def walk(node):
        if isinstance(node, ast.Constant) and type(node.value) is int:
            return space(node.value), space.one
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
            top, under = walk(node.operand)
            return -top, under
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Pow):
            (top, under), power = walk(node.left), ast.literal_eval(node.right)
            top, under = (under, top) if power < 0 else (top, under)
            return top ** abs(power), under ** abs(power)
        if isinstance(node, ast.BinOp):
            (a, b), (c, e) = walk(node.left), walk(node.right)
            if isinstance(node.op, ast.Mult):
                return a * c, b * e
            if isinstance(node.op, ast.Div):
                return a * e, b * c
            sign = {ast.Add: 1, ast.Sub: -1}[type(node.op)]
            return (a + sign * c, b) if b == e else (a * e + sign * c * b, b * e)
        text = ast.unparse(node)
        if text in plain:
            return quotient(plain[text])
        if text in definitions:
            return quotient(definitions[text])
        if text in known:
            return known[text]
        raise ValueError(f"nothing is known of {text}")

    def top(left, right):
        (a, b), (c, e) = quotient(left), quotient(right)
        if not b or not e:
            raise ZeroDivisionError(f"{left} = {right} has no value anywhere")
        difference = a - c if b == e else a * e - c * b
        return difference.clear_denoms()[1] if difference else difference

    numbers_agree(names, plain, definitions, variables)
    N = top(left, right)
    combination = sum((quotient(q)[0] * top(a, b) for a, b, q in relations), space.zero)
    if not quotient(d)[0]:
        raise ZeroDivisionError("d is 0")
    difference = quotient(d)[0] * N - combination
    print(difference)
    if difference:
        sys.exit(1)


def real(function, allowed=lambda *a: True):
    def call(*arguments):
        if not allowed(*arguments):
            raise ValueError("no real value")
        return function(*arguments)

    return call


REAL = {
    "sqrt": real(mpmath.sqrt, lambda x: x >= 0), "Abs": abs, "sin": mpmath.sin, "cos": mpmath.cos, "tan": mpmath.tan,
    "exp": mpmath.exp, "log": real(mpmath.log, lambda x: x > 0), "sinh": mpmath.sinh, "cosh": mpmath.cosh,
    "tanh": mpmath.tanh, "asin": real(mpmath.asin, lambda x: abs(x) <= 1), "acos": real(mpmath.acos, lambda x: abs(x) <= 1),
    "atan": mpmath.atan, "atan2": mpmath.atan2, "agm": real(mpmath.agm, lambda x, y: x > 0 and y > 0),
    "power": real(mpmath.power, lambda x, y: x > 0),
}


def numbers_agree(names, functions, definitions, variables):
    """At random numbers, each call of a function has the value of what stands for it: to 40 digits."""
    mpmath.mp.dps = 50
    random.seed(1)
    free = [name for name in names if name not in variables and name not in definitions]
    good = 0
    for _ in range(400 if functions else 0):
        scale = random.choice([1, 10, 100])
        values = {name: mpmath.mpf(random.randint(-99, 99)) / (random.randint(50, 99) * scale) for name in free}
        values = {name: abs(value) if random.random() < 0.5 else value for name, value in values.items()}

        def number(text):
            return walk(ast.parse(text, mode="eval").body)

        def walk(node):
            if isinstance(node, ast.Constant):
                return mpmath.mpf(node.value)
            if isinstance(node, ast.UnaryOp):
                return -walk(node.operand)
            if isinstance(node, ast.BinOp):
                if isinstance(node.op, ast.Pow):
                    return walk(node.left) ** ast.literal_eval(node.right)
                a, b = walk(node.left), walk(node.right)
                return {ast.Add: lambda: a + b, ast.Sub: lambda: a - b, ast.Mult: lambda: a * b, ast.Div: lambda: a / b}[
                    type(node.op)
                ]()
            if isinstance(node, ast.Call):
                return REAL[node.func.id](*map(walk, node.args))
            name = node.id
            if name == "pi":
                return +mpmath.pi
            if name not in values:
                values[name] = number(variables[name] if name in variables else definitions[name])
            return values[name]

        try:
            pairs = [(call, number(call), number(image)) for call, image in functions.items()]
        except (ValueError, ZeroDivisionError):
            continue
        for call, one, other in pairs:
            if abs(one - other) > mpmath.mpf(10) ** -40 * (1 + abs(one)):
                sys.exit(f"{call} is not {functions[call]}")
        good += 1
        if good == 3:
            return
    if functions and not good:
        sys.exit("no numbers were found for which the functions have values")


# Equation 1: \dot{Q}_{11} = -(\frac{{\bf m}_3}{I_2}\cdot Q_{32}\cdot Q_{13}+\frac{{\bf m}_3}{I_3}\cdot (-1)\cdot Q_{33}\cdot Q_{12})
# where {\bf m}_3 = {\bf m}_3(0)
# where Q_{12} = -\sin(\frac{{\bf m}_3(0)}{I_3}\cdot t)
# where Q_{13} = 0
# where Q_{32} = 0
# where Q_{33} = 1
# where \dot{Q}_{11} = -\sin(\frac{{\bf m}_3(0)}{I_3}\cdot t)\cdot \frac{{\bf m}_3(0)}{I_3}
# I3 stands for I_3
# I2 stands for I_2
check(
    names=["sin_2", "cos_2", "m3_then", "m2_then", "m1_then", "I3", "I2", "I1", "m3", "t", "Q12", "Q13", "Q32", "Q33", "Q11_dot"],
    left="Q11_dot",
    right="-(m3/I2*Q32*Q13 + m3/I3*(-1)*Q33*Q12)",
    relations=[
    ],
    d="1",
    definitions={
        "Q11_dot": "-(sin(m3_then/I3*t)*(m3_then/I3))",
        "m3": "m3_then",
        "Q12": "-sin(m3_then/I3*t)",
        "Q13": "0",
        "Q32": "0",
        "Q33": "1",
    },
    functions={
        "sin(m3_then/I3*t)": "sin_2",
    },
    variables={
        "sin_2": "sin(I3**(-1)*t*m3_then)",
        "cos_2": "cos(I3**(-1)*t*m3_then)",
    },
)


# Equation 2: \dot{Q}_{12} = -(\frac{{\bf m}_3}{I_1}\cdot (-1)\cdot Q_{31}\cdot Q_{13}+\frac{{\bf m}_3}{I_3}\cdot Q_{33}\cdot Q_{11})
# where {\bf m}_3 = {\bf m}_3(0)
# where Q_{11} = \cos(\frac{{\bf m}_3(0)}{I_3}\cdot t)
# where Q_{13} = 0
# where Q_{31} = 0
# where Q_{33} = 1
# where \dot{Q}_{12} = -\cos(\frac{{\bf m}_3(0)}{I_3}\cdot t)\cdot \frac{{\bf m}_3(0)}{I_3}
# I3 stands for I_3
# I1 stands for I_1
check(
    names=["sin_2", "cos_2", "m3_then", "m2_then", "m1_then", "I3", "I2", "I1", "m3", "t", "Q11", "Q13", "Q31", "Q33", "Q12_dot"],
    left="Q12_dot",
    right="-(m3/I1*(-1)*Q31*Q13 + m3/I3*Q33*Q11)",
    relations=[
    ],
    d="1",
    definitions={
        "Q12_dot": "-(cos(m3_then/I3*t)*(m3_then/I3))",
        "m3": "m3_then",
        "Q11": "cos(m3_then/I3*t)",
        "Q13": "0",
        "Q31": "0",
        "Q33": "1",
    },
    functions={
        "cos(m3_then/I3*t)": "cos_2",
    },
    variables={
        "sin_2": "sin(I3**(-1)*t*m3_then)",
        "cos_2": "cos(I3**(-1)*t*m3_then)",
    },
)


# Equation 3: \dot{Q}_{13} = -(\frac{{\bf m}_3}{I_1}\cdot Q_{31}\cdot Q_{12}+\frac{{\bf m}_3}{I_2}\cdot (-1)\cdot Q_{32}\cdot Q_{11})
# where {\bf m}_3 = {\bf m}_3(0)
# where Q_{11} = \cos(\frac{{\bf m}_3(0)}{I_3}\cdot t)
# where Q_{12} = -\sin(\frac{{\bf m}_3(0)}{I_3}\cdot t)
# where Q_{31} = 0
# where Q_{32} = 0
# where \dot{Q}_{13} = 0
# I2 stands for I_2
# I1 stands for I_1
check(
    names=["sin_2", "cos_2", "m3_then", "m2_then", "m1_then", "I3", "I2", "I1", "m3", "t", "Q11", "Q12", "Q31", "Q32", "Q13_dot"],
    left="Q13_dot",
    right="-(m3/I1*Q31*Q12 + m3/I2*(-1)*Q32*Q11)",
    relations=[
    ],
    d="1",
    definitions={
        "Q13_dot": "0",
        "m3": "m3_then",
        "Q11": "cos(m3_then/I3*t)",
        "Q12": "-sin(m3_then/I3*t)",
        "Q31": "0",
        "Q32": "0",
    },
    functions={
        "cos(m3_then/I3*t)": "cos_2",
        "sin(m3_then/I3*t)": "sin_2",
    },
    variables={
        "sin_2": "sin(I3**(-1)*t*m3_then)",
        "cos_2": "cos(I3**(-1)*t*m3_then)",
    },
)


# Equation 4: \dot{Q}_{21} = -(\frac{{\bf m}_3}{I_2}\cdot Q_{32}\cdot Q_{23}+\frac{{\bf m}_3}{I_3}\cdot (-1)\cdot Q_{33}\cdot Q_{22})
# where {\bf m}_3 = {\bf m}_3(0)
# where Q_{22} = \cos(\frac{{\bf m}_3(0)}{I_3}\cdot t)
# where Q_{23} = 0
# where Q_{32} = 0
# where Q_{33} = 1
# where \dot{Q}_{21} = \cos(\frac{{\bf m}_3(0)}{I_3}\cdot t)\cdot \frac{{\bf m}_3(0)}{I_3}
# I3 stands for I_3
# I2 stands for I_2
check(
    names=["sin_2", "cos_2", "m3_then", "m2_then", "m1_then", "I3", "I2", "I1", "m3", "t", "Q22", "Q23", "Q32", "Q33", "Q21_dot"],
    left="Q21_dot",
    right="-(m3/I2*Q32*Q23 + m3/I3*(-1)*Q33*Q22)",
    relations=[
    ],
    d="1",
    definitions={
        "Q21_dot": "cos(m3_then/I3*t)*(m3_then/I3)",
        "m3": "m3_then",
        "Q22": "cos(m3_then/I3*t)",
        "Q23": "0",
        "Q32": "0",
        "Q33": "1",
    },
    functions={
        "cos(m3_then/I3*t)": "cos_2",
    },
    variables={
        "sin_2": "sin(I3**(-1)*t*m3_then)",
        "cos_2": "cos(I3**(-1)*t*m3_then)",
    },
)


# Equation 5: \dot{Q}_{22} = -(\frac{{\bf m}_3}{I_1}\cdot (-1)\cdot Q_{31}\cdot Q_{23}+\frac{{\bf m}_3}{I_3}\cdot Q_{33}\cdot Q_{21})
# where {\bf m}_3 = {\bf m}_3(0)
# where Q_{21} = \sin(\frac{{\bf m}_3(0)}{I_3}\cdot t)
# where Q_{23} = 0
# where Q_{31} = 0
# where Q_{33} = 1
# where \dot{Q}_{22} = -\sin(\frac{{\bf m}_3(0)}{I_3}\cdot t)\cdot \frac{{\bf m}_3(0)}{I_3}
# I3 stands for I_3
# I1 stands for I_1
check(
    names=["sin_2", "cos_2", "m3_then", "m2_then", "m1_then", "I3", "I2", "I1", "m3", "t", "Q21", "Q23", "Q31", "Q33", "Q22_dot"],
    left="Q22_dot",
    right="-(m3/I1*(-1)*Q31*Q23 + m3/I3*Q33*Q21)",
    relations=[
    ],
    d="1",
    definitions={
        "Q22_dot": "-(sin(m3_then/I3*t)*(m3_then/I3))",
        "m3": "m3_then",
        "Q21": "sin(m3_then/I3*t)",
        "Q23": "0",
        "Q31": "0",
        "Q33": "1",
    },
    functions={
        "sin(m3_then/I3*t)": "sin_2",
    },
    variables={
        "sin_2": "sin(I3**(-1)*t*m3_then)",
        "cos_2": "cos(I3**(-1)*t*m3_then)",
    },
)


# Equation 6: \dot{Q}_{23} = -(\frac{{\bf m}_3}{I_1}\cdot Q_{31}\cdot Q_{22}+\frac{{\bf m}_3}{I_2}\cdot (-1)\cdot Q_{32}\cdot Q_{21})
# where {\bf m}_3 = {\bf m}_3(0)
# where Q_{21} = \sin(\frac{{\bf m}_3(0)}{I_3}\cdot t)
# where Q_{22} = \cos(\frac{{\bf m}_3(0)}{I_3}\cdot t)
# where Q_{31} = 0
# where Q_{32} = 0
# where \dot{Q}_{23} = 0
# I2 stands for I_2
# I1 stands for I_1
check(
    names=["sin_2", "cos_2", "m3_then", "m2_then", "m1_then", "I3", "I2", "I1", "m3", "t", "Q21", "Q22", "Q31", "Q32", "Q23_dot"],
    left="Q23_dot",
    right="-(m3/I1*Q31*Q22 + m3/I2*(-1)*Q32*Q21)",
    relations=[
    ],
    d="1",
    definitions={
        "Q23_dot": "0",
        "m3": "m3_then",
        "Q21": "sin(m3_then/I3*t)",
        "Q22": "cos(m3_then/I3*t)",
        "Q31": "0",
        "Q32": "0",
    },
    functions={
        "sin(m3_then/I3*t)": "sin_2",
        "cos(m3_then/I3*t)": "cos_2",
    },
    variables={
        "sin_2": "sin(I3**(-1)*t*m3_then)",
        "cos_2": "cos(I3**(-1)*t*m3_then)",
    },
)


# Equation 7: \dot{Q}_{31} = -(\frac{{\bf m}_3}{I_2}\cdot Q_{32}\cdot Q_{33}+\frac{{\bf m}_3}{I_3}\cdot (-1)\cdot Q_{33}\cdot Q_{32})
# where {\bf m}_3 = {\bf m}_3(0)
# where Q_{32} = 0
# where Q_{33} = 1
# where \dot{Q}_{31} = 0
# I3 stands for I_3
# I2 stands for I_2
check(
    names=["sin_2", "cos_2", "m3_then", "m2_then", "m1_then", "I3", "I2", "I1", "m3", "t", "Q32", "Q33", "Q31_dot"],
    left="Q31_dot",
    right="-(m3/I2*Q32*Q33 + m3/I3*(-1)*Q33*Q32)",
    relations=[
    ],
    d="1",
    definitions={
        "Q31_dot": "0",
        "m3": "m3_then",
        "Q32": "0",
        "Q33": "1",
    },
    variables={
        "sin_2": "sin(I3**(-1)*t*m3_then)",
        "cos_2": "cos(I3**(-1)*t*m3_then)",
    },
)


# Equation 8: \dot{Q}_{32} = -(\frac{{\bf m}_3}{I_1}\cdot (-1)\cdot Q_{31}\cdot Q_{33}+\frac{{\bf m}_3}{I_3}\cdot Q_{33}\cdot Q_{31})
# where {\bf m}_3 = {\bf m}_3(0)
# where Q_{31} = 0
# where Q_{33} = 1
# where \dot{Q}_{32} = 0
# I3 stands for I_3
# I1 stands for I_1
check(
    names=["sin_2", "cos_2", "m3_then", "m2_then", "m1_then", "I3", "I2", "I1", "m3", "t", "Q31", "Q33", "Q32_dot"],
    left="Q32_dot",
    right="-(m3/I1*(-1)*Q31*Q33 + m3/I3*Q33*Q31)",
    relations=[
    ],
    d="1",
    definitions={
        "Q32_dot": "0",
        "m3": "m3_then",
        "Q31": "0",
        "Q33": "1",
    },
    variables={
        "sin_2": "sin(I3**(-1)*t*m3_then)",
        "cos_2": "cos(I3**(-1)*t*m3_then)",
    },
)


# Equation 9: \dot{Q}_{33} = -(\frac{{\bf m}_3}{I_1}\cdot Q_{31}\cdot Q_{32}+\frac{{\bf m}_3}{I_2}\cdot (-1)\cdot Q_{32}\cdot Q_{31})
# where {\bf m}_3 = {\bf m}_3(0)
# where Q_{31} = 0
# where Q_{32} = 0
# where \dot{Q}_{33} = 0
# I2 stands for I_2
# I1 stands for I_1
check(
    names=["sin_2", "cos_2", "m3_then", "m2_then", "m1_then", "I3", "I2", "I1", "m3", "t", "Q31", "Q32", "Q33_dot"],
    left="Q33_dot",
    right="-(m3/I1*Q31*Q32 + m3/I2*(-1)*Q32*Q31)",
    relations=[
    ],
    d="1",
    definitions={
        "Q33_dot": "0",
        "m3": "m3_then",
        "Q31": "0",
        "Q32": "0",
    },
    variables={
        "sin_2": "sin(I3**(-1)*t*m3_then)",
        "cos_2": "cos(I3**(-1)*t*m3_then)",
    },
)


# Equation 10: Q_{11}(0) = 1
# where Q_{11}(0) = \cos(\frac{{\bf m}_3(0)}{I_3}\cdot 0)
check(
    names=["sin_2", "cos_2", "m3_then", "m2_then", "m1_then", "I3", "I2", "I1", "t", "Q11_then"],
    left="Q11_then",
    right="1",
    relations=[
    ],
    d="1",
    definitions={
        "Q11_then": "cos(m3_then/I3*0)",
    },
    functions={
        "cos(m3_then/I3*0)": "1",
    },
    variables={
        "sin_2": "sin(I3**(-1)*t*m3_then)",
        "cos_2": "cos(I3**(-1)*t*m3_then)",
    },
)


# Equation 11: Q_{12}(0) = 0
# where Q_{12}(0) = -\sin(\frac{{\bf m}_3(0)}{I_3}\cdot 0)
check(
    names=["sin_2", "cos_2", "m3_then", "m2_then", "m1_then", "I3", "I2", "I1", "t", "Q12_then"],
    left="Q12_then",
    right="0",
    relations=[
    ],
    d="1",
    definitions={
        "Q12_then": "-sin(m3_then/I3*0)",
    },
    functions={
        "sin(m3_then/I3*0)": "0",
    },
    variables={
        "sin_2": "sin(I3**(-1)*t*m3_then)",
        "cos_2": "cos(I3**(-1)*t*m3_then)",
    },
)


# Equation 12: Q_{21}(0) = 0
# where Q_{21}(0) = \sin(\frac{{\bf m}_3(0)}{I_3}\cdot 0)
check(
    names=["sin_2", "cos_2", "m3_then", "m2_then", "m1_then", "I3", "I2", "I1", "t", "Q21_then"],
    left="Q21_then",
    right="0",
    relations=[
    ],
    d="1",
    definitions={
        "Q21_then": "sin(m3_then/I3*0)",
    },
    functions={
        "sin(m3_then/I3*0)": "0",
    },
    variables={
        "sin_2": "sin(I3**(-1)*t*m3_then)",
        "cos_2": "cos(I3**(-1)*t*m3_then)",
    },
)


# Equation 13: Q_{22}(0) = 1
# where Q_{22}(0) = \cos(\frac{{\bf m}_3(0)}{I_3}\cdot 0)
check(
    names=["sin_2", "cos_2", "m3_then", "m2_then", "m1_then", "I3", "I2", "I1", "t", "Q22_then"],
    left="Q22_then",
    right="1",
    relations=[
    ],
    d="1",
    definitions={
        "Q22_then": "cos(m3_then/I3*0)",
    },
    functions={
        "cos(m3_then/I3*0)": "1",
    },
    variables={
        "sin_2": "sin(I3**(-1)*t*m3_then)",
        "cos_2": "cos(I3**(-1)*t*m3_then)",
    },
)
